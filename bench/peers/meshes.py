"""What others say of the files that `emboss` writes: trimesh, and admesh where it is installed.

usage: meshes.py [PLACEMENT...]        the program is pra-tactile, in PATH
Embosses the canonical placement, and those named, as binary STL; prints a line a file and peer, and ends with status 1 if one of
them finds an open edge, a flipped normal, or a volume that is off by more than 1 in 100000, or by admesh, which sums it up in
numbers of 32 bits, 1 in 10000.
"""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from fractions import Fraction
from math import sqrt


def exact(text):
    """The volume as emboss tells it: a fraction, and where it is none the root of another one added."""
    whole, root = re.fullmatch(r"([^+]*)(?:[+]sqrt[(](.*)[)])?", text).groups()
    return float(Fraction(whole)) + (sqrt(Fraction(root)) if root else 0)


def by_trimesh(file):
    import trimesh

    # It joins what is the same point: a triangle soup has no edges.
    mesh = trimesh.load(file, process=True)
    return mesh.is_watertight, mesh.is_winding_consistent, mesh.volume


def by_admesh(file):
    said = subprocess.run(["admesh", "--exact", file], capture_output=True, text=True, check=True).stdout

    def number(what):
        return float(re.search(what + r"\s*:\s*(\S+)", said).group(1))

    wrong = [number(what) for what in ("Facets reversed", "Backwards edges", "Normals fixed")]
    open_edges = number("Total disconnected facets") + number("Degenerate facets")
    return open_edges == 0, sum(wrong) == 0, number("Volume")


def main():
    peers = {"trimesh": by_trimesh}
    if shutil.which("admesh"):
        peers["admesh"] = by_admesh
    else:
        print("admesh is not installed here: apt-get install admesh")
    good = True
    with tempfile.TemporaryDirectory() as folder:
        for number, placement in enumerate([None] + sys.argv[1:]):
            out = os.path.join(folder, str(number))
            chosen = ["--placement", placement] if placement else []
            command = ["pra-tactile", "emboss", "--json", "--output", out] + chosen
            told = subprocess.run(command, capture_output=True, text=True, check=True).stdout
            for made in json.loads(told)["files"]:
                volume = exact(made["volume_mm3"])
                for name, peer in peers.items():
                    closed, oriented, found = peer(made["file"])
                    off = abs(found / volume - 1)
                    good = good and closed and oriented and off < (1e-4 if name == "admesh" else 1e-5)
                    print(f"{made['object']}: {made['triangles']} triangles; {name}: "
                          f"{'closed' if closed else 'OPEN'}, {'oriented' if oriented else 'FLIPPED'}, volume off by {off:.1e}")
    return 0 if good else 1


sys.exit(main())
