#!/usr/bin/env python3
"""Writes Certificates.v, the committed certificates as Coq values, from what the program issues:
python3 proofs/certificates.py bin/pra-tactile > proofs/Certificates.v
The kernel checks the values, so this script need not be trusted; a test holds them equal to what the library issues."""
import glob, json, os, subprocess, sys

program = sys.argv[1]
profiles = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data", "profiles", "*.json")

def run(*arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout

def certificate(*arguments):
    return json.loads(run("certificate", "--rank", *arguments))

def coq(x):  # a list of numbers, of lists or of tuples
    if isinstance(x, list):
        return "[" + "; ".join(map(coq, x)) + "]"
    return "(" + ", ".join(map(coq, x)) + ")" if isinstance(x, tuple) else str(int(x))

NAMES = {"characteristic": "Characteristic", "reciprocal": "Reciprocal", "diagonal": "Diagonal", "row-major": "RowMajor",
         "torus": "Torus", "twisted-torus": "TwistedTorus", "sheet": "Sheet"}

def value(c):
    p, e = c["profile"], c["evidence"]
    factors = [(f["prime"], f["exponent"], list(f["residue"])) for f in c["factors"]]
    primes = [(f["prime"], [tuple(w) for w in f["factors"]]) for f in c["primes"]]
    parts = [
        "(Profile %s %s %s %s" % (coq(p["q"]), coq(p["modulus"]), coq(p["polynomial"]), NAMES[p["reading"]]),
        "   %s %s %s %s %s)" % (coq(p["state"]), *map(coq, p["shape"]), NAMES[p["folding"]], NAMES[p["surface"]]),
        "%s %s %s %s" % (coq(tuple(p["window"])), coq([tuple(o) for o in c["mask"]]), coq(c["windows"]), coq(c["period"])),
        "%s %s" % (coq(factors), coq(primes)),
        coq(e["vectors"]), "%s %s" % (coq(e["cells"]), coq(e["inverse"]))]
    return "  (Certificate\n    " + "\n    ".join(parts) + ")"

def definition(what, name, certificates):
    print("\n(* %s *)\nDefinition %s : list certificate := [" % (what, name))
    print(";\n".join(map(value, certificates)) + "].")

print("""(* Certificates that `pra-tactile certificate --rank` issued, as values. certificates.py writes this file.

   Good.v has the kernel check them; a test compares them with what PraTactile.Certificate issues. *)
From Coq Require Import NArith List.
From PraTactile Require Import Grid Checker.
Import ListNotations.
Local Open Scope N_scope.""")
definition("The paper's array, with a 2 x 2 window.", "paperCertificates", [certificate()])
quartics = run("polynomials", "--q", "4", "--degree", "4").split()
definition("The arrays of all %d primitive quartics over GF(4), 15 x 17 with a 2 x 2 window." % len(quartics),
           "quarticCertificates",
           [certificate("--q", "4", "--polynomial", h, "--shape", "15x17", "--window", "2x2") for h in quartics])
definition("The shipped profiles, in the order of their names.", "shippedCertificates",
           [certificate("--profile", p) for p in sorted(glob.glob(profiles))])
definition("The paper's array row by row on the twisted torus, cut to a sheet, and with a mask.", "otherCertificates",
           [certificate("--folding", "row-major", "--surface", "twisted-torus"),
            certificate("--surface", "sheet"), certificate("--mask", "##./.##")])
