# pra-tactile: everything a newcomer types. `make demo` and `make test` install what they need.
CABAL = tools/cabal.sh
.PHONY: all setup build demo test fuzz prove bench evaluate house shapes network check-network clean

all: build

setup:
	@$(CABAL) setup

# The executable, as bin/pra-tactile.
build: setup
	@$(CABAL) build -v1 exe:pra-tactile
	@mkdir -p bin
	@cp -f "$$($(CABAL) list-bin -v0 exe:pra-tactile)" bin/pra-tactile

# Recognise an object by touch, from PGM frames on disk.
demo: build
	@sh tools/demo.sh

test: setup build
	@$(CABAL) doctests
	@$(CABAL) test -v1 --test-show-details=streaming test:spec

# A million hostile inputs through the parsers and ten thousand through the program (about half an hour; the test suite has a
# tenth of them). What is found is printed with the seed that finds it again.
fuzz: setup build
	@PRA_TACTILE_HOSTILE=1000000 $(CABAL) test -v1 --test-show-details=streaming test:spec \
	  --test-option=--match --test-option="/Hostile inputs/"

# Every array to 2^20 cells by both roads; to 2^16 cells with every primitive polynomial (about four minutes).
prove: setup build
	@PRA_TACTILE_EXHAUSTIVE=20 $(CABAL) test -v1 --test-show-details=streaming test:spec \
	  --test-option=--match --test-option="/The code/Exhaustive proofs/"

# The figure that matters: 1000 simulated presses, with and without stitching.
evaluate: build
	bin/pra-tactile evaluate --presses 1000 --seed 1

bench: setup
	@$(CABAL) bench -v1

# Draw the module graph (house.dot; house.svg where Graphviz is installed).
house: setup
	@runghc -itest tools/House.hs > house.dot
	@if command -v dot >/dev/null 2>&1; then dot -Tsvg house.dot > house.svg && echo "wrote house.dot and house.svg"; \
	 else echo "wrote house.dot (install Graphviz to have house.svg drawn)"; fi

# Make the shipped data again from their seeds.
shapes: build
	bin/pra-tactile shapes --design --output data/shapes.txt
network: build
	bin/pra-tactile train --output data/network.txt

# The trained weights are reproduced to the bit from their seed (about a minute; with the reference BLAS).
check-network: build
	bin/pra-tactile train --output dist-newstyle/network-again.txt
	cmp data/network.txt dist-newstyle/network-again.txt && echo "data/network.txt is reproduced to the bit"

clean:
	rm -rf dist-newstyle bin demo-out house.dot house.svg
