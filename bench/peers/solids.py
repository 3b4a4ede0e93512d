"""How long it takes to examine a torus of triangles from a binary STL file, beside trimesh and, where it is installed, pymeshlab.

usage: solids.py [TRIANGLES...]        default: 100000 1000000; the program is pra-tactile, in PATH
Prints a line a size and program: seconds of the processor, the most memory, and what it says. Ours says exactly what is wrong,
intersections of faces included; trimesh whether the surface is closed and its volume, and pymeshlab how many faces intersect, both
in floating point.
"""

import math
import os
import resource
import subprocess
import sys
import tempfile

import numpy


def torus(file, triangles):
    """So many triangles, about, as a binary STL; the larger radius is 100 mm, the smaller one 40."""
    down = round(math.sqrt(triangles / 2 / 1.25))
    around = round(triangles / 2 / down)
    a, b = numpy.meshgrid(2 * numpy.pi * numpy.arange(around) / around, 2 * numpy.pi * numpy.arange(down) / down, indexing="ij")
    far = 100 + 40 * numpy.cos(b)
    points = numpy.stack([far * numpy.cos(a), far * numpy.sin(a), 40 * numpy.sin(b)], axis=-1).astype("<f4")

    def at(i, j):
        return numpy.roll(points, (-i, -j), axis=(0, 1))

    halves = [numpy.stack(corners, axis=2) for corners in [(at(0, 0), at(1, 0), at(1, 1)), (at(0, 0), at(1, 1), at(0, 1))]]
    rows = numpy.zeros(2 * around * down, dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    rows["corners"] = numpy.concatenate([half.reshape(-1, 3, 3) for half in halves])
    with open(file, "wb") as out:
        out.write(bytes(80) + len(rows).to_bytes(4, "little") + rows.tobytes())


def ours(file):
    said = subprocess.run(["pra-tactile", "solid", file], capture_output=True, text=True, check=True).stdout.splitlines()
    return f"{said[0].split(': ')[1]}, {next(line.strip() for line in said if 'piece: ' in line)}"


def trimesh(file):
    import trimesh as peer

    mesh = peer.load(file, process=True)
    return f"closed: {mesh.is_watertight}, volume {mesh.volume:.6g}"


def pymeshlab(file):
    import pymeshlab as peer

    meshes = peer.MeshSet()
    meshes.load_new_mesh(file)
    meshes.meshing_remove_duplicate_vertices()
    meshes.compute_selection_by_self_intersections_per_face()
    return f"faces that intersect: {meshes.current_mesh().selected_face_number()}"


def measured(function, file):
    """The function in a process of its own, imports included: seconds of the processor, MiB, its answer."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.write(writing, function(file).encode())
        except ImportError as problem:
            os.write(writing, str(problem).encode())
        own, others = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
        seconds = sum(used.ru_utime + used.ru_stime for used in (own, others))
        os.write(writing, f"\n{seconds} {max(own.ru_maxrss, others.ru_maxrss) / 1024}".encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as said:
        answer, used = said.read().split("\n")
    os.waitpid(child, 0)
    return [float(number) for number in used.split()] + [answer]


def main():
    for triangles in [int(size) for size in sys.argv[1:]] or [100_000, 1_000_000]:
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "torus.stl")
            torus(file, triangles)
            for function in (ours, trimesh, pymeshlab):
                seconds, memory, answer = measured(function, file)
                print(f"{triangles} triangles, {function.__name__}: {seconds:.2f} s, {memory:.0f} MiB; {answer}", flush=True)


main()
