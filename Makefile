# pra-tactile: everything a newcomer types. `make help` says what there is; the first two install what they need.
# A line of the help is what stands behind ## on a target's own line.
CABAL = tools/cabal.sh
PREFIX = /usr/local
DESTDIR =
# Only the tests whose path has this in it, as in: make test MATCH="/The command line: census/"
MATCH =
# The seed of random cases, as in: make test SEED=7
SEED =
export PREFIX DESTDIR
.PHONY: all help setup build demo test test-full proofs static packages check-packages check-slurm lint format mutants calibration archive operations types bench evaluate figures docs shapes network \
        check-network check-newer-ghc install uninstall clean
# cabal holds one build at a time in dist-newstyle.
.NOTPARALLEL:

all: build

demo: build ## recognise an object by touch, from PGM frames on disk
	@sh tools/demo.sh

test: setup ## run the test suite as far as a person waits for it (MATCH=... for a part of it)
	@tools/build.sh test:spec
	@$(CABAL) doctests
	@tools/test.sh $(if $(MATCH),--match "$(MATCH)") $(if $(SEED),--seed $(SEED))

test-full: ## run all that the suite has, with random cases from a fresh seed, which it prints
	@PRA_TACTILE_EFFORT=full $(MAKE) --no-print-directory test

proofs: ## check the machine-checked proofs in proofs/ (Coq 8.16, mathcomp 1.15); a line a theorem
	@tools/proofs.sh

lint: ## check the sources: 100 columns, ormolu, hlint
	@tools/lint.sh

format: ## format the sources by ormolu 0.3.1
	@tools/format.sh

build: setup ## build the program, as bin/pra-tactile
	@tools/build.sh

static: build ## link one program that needs nothing of the system it runs on, dist/pra-tactile
	@tools/static.sh

packages: build ## an archive, a Debian package and a Python wheel of it, in dist/
	@tools/packages.sh

check-packages: ## use each of them as its users would, in an empty root, a bare Debian, a virtual environment (root)
	@tools/check-packages.sh

check-slurm: build ## census and evaluation as job arrays of a Slurm of its own, one task killed (root, slurm-wlm)
	@tools/check-slurm.sh

install: bin/pra-tactile ## install program, manual pages and completions under PREFIX (/usr/local)
	@tools/install.sh install

uninstall: ## remove them again
	@tools/install.sh uninstall

setup: ## install Debian's packages, unless a suitable GHC and cabal are there
	@$(CABAL) setup

# `sudo make install` after `make build` builds nothing as root.
bin/pra-tactile:
	@$(MAKE) --no-print-directory build

evaluate: build ## the figure that matters: 1000 simulated presses, with and without stitching
	bin/pra-tactile evaluate --presses 1000 --seed 1

# A file or more: make figures FILES=docs/results/rates.md. Half an hour for all, on two cores with nothing else to do.
figures: build ## run the commands that README and docs show, and put there what they print
	@PATH="$(CURDIR)/bin:$$PATH" runghc $$(tools/extensions.sh) -itest tools/Figures.hs $(FILES)

bench: setup ## the benchmarks
	@tools/build.sh bench:bench
	@$(CABAL) bench -v1 bench:bench

# SYMBOLS=300 of each sensor and angle; about two minutes for each field.
calibration: setup ## how many symbols are told and counted wrong with each shipped alphabet, by decade of doubt
	@tools/build.sh bench:calibrate
	@"$$(tools/cabal.sh list-bin -v0 bench:calibrate)" $(or $(SYMBOLS),300)

# SEEDS=20; about 20 minutes on two cores. Which laws find which is kept in data/impostors.txt.
mutants: setup ## which laws find which impostor, and whether each is found with each of 20 seeds
	@tools/build.sh bench:mutants
	@"$$(tools/cabal.sh list-bin -v0 bench:mutants)" $(or $(SEEDS),20)

# From the records in src/conformance/PraTactile/Conformance/Operations; a test holds them equal.
operations: setup ## write the operations of the protocol into docs/reference/protocol.md and data/schemas
	@runghc $$(tools/extensions.sh) $(patsubst %,-i%,$(wildcard src/*)) tools/Operations.hs

types: ## types from the schemas in Python, TypeScript and Go, compiled (FOLDER=... keeps them)
	@tools/types.sh $(FOLDER)

archive: ## vectors, schemas, the list of laws and their sums as one reproducible file, for tests without a network
	@tools/archive.sh

docs: setup ## the documentation of all libraries, as HTML; a link to a module of ours that leads nowhere is an error
	@tools/docs.sh

# Of GF(4) the files are data/shapes.txt and data/network.txt, of every other field data/alphabets/gfQ.
shapes: build ## design the shipped shapes again from their seed (some five minutes)
	bin/pra-tactile shapes --design --output data/shapes.txt
	for q in 2 3 5 7 8 9; do bin/pra-tactile shapes --design --q $$q --output data/alphabets/gf$$q/shapes.txt || exit 1; done

network: build ## train the shipped networks again from their seed
	bin/pra-tactile train --output data/network.txt --network-calibration data/calibration.txt
	for q in 2 3 5 7 8 9; do \
	  bin/pra-tactile train --q $$q --output data/alphabets/gf$$q/network.txt --network-calibration data/alphabets/gf$$q/calibration.txt || exit 1; \
	done

# One to nine minutes each, by the machine and the number of shapes; with the reference BLAS.
check-network: build ## check that weights and calibrations are reproduced to the bit
	for q in 4 2 3 5 7 8 9; do \
	  folder=data/alphabets/gf$$q; [ $$q != 4 ] || folder=data; \
	  bin/pra-tactile train --q $$q --output dist-newstyle/network.txt --network-calibration dist-newstyle/calibration.txt \
	    && cmp $$folder/network.txt dist-newstyle/network.txt && cmp $$folder/calibration.txt dist-newstyle/calibration.txt \
	    && echo "$$folder/network.txt and its calibration are reproduced to the bit" || exit 1; \
	done

check-newer-ghc: ## demo and tests on a bare Debian with a newer GHC, in a chroot (root; SUITE=trixie)
	@tools/newer-ghc.sh

clean: ## remove what was built
	rm -rf dist-newstyle bin dist demo-out

help: ## this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-16s %s\n", $$1, $$2 }' Makefile
