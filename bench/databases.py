#!/usr/bin/env python3
"""Databases on a server of PostgreSQL beside those in files: how long 10 000 boxes take, that every answer is the same, and that
nothing is lost when programs, or the server, are killed while they write. It starts a server of its own in a new folder, as the
user postgres where it is root's, and ends it.

usage: bench/databases.py [--boxes 10000] [--positions 100000] [--kills 1000] [--server-kills 100] [--rounds 1000]

The boxes are cubes of 127 mm, whose 60 000 faces take 1 200 000 cells of an array of 2047 x 2049 over GF(4).
"""

import argparse
import glob
import json
import os
import pwd
import random
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time

PROGRAM = os.environ.get("PRA_TACTILE", "bin/pra-tactile")
FACES = [["V2", "V6", "V7", "V3"], ["V3", "V7", "V8", "V4"], ["V4", "V8", "V5", "V1"],
         ["V1", "V2", "V3", "V4"], ["V1", "V5", "V6", "V2"], ["V6", "V5", "V8", "V7"]]
CORNERS = [(0, 1, 1), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 0), (0, 0, 0), (1, 0, 0), (1, 1, 0)]


def pra(*arguments, **more):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, **more)


def checked(*arguments, **more):
    done = pra(*arguments, **more)
    if done.returncode != 0:
        raise SystemExit(f"{arguments}: {done.stderr}")
    return done.stdout


class Server:
    def __init__(self):
        self.folder = tempfile.mkdtemp(prefix="pra-tactile.", dir="/tmp")
        self.user = None
        if os.geteuid() == 0:
            self.user = "postgres"
            entry = pwd.getpwnam(self.user)
            os.chown(self.folder, entry.pw_uid, entry.pw_gid)
        self.programs = sorted(glob.glob("/usr/lib/postgresql/*/bin"))[-1]
        self.data = os.path.join(self.folder, "data")
        subprocess.run([self.programs + "/initdb", "-D", self.data, "-U", "postgres", "-A", "trust", "-E", "UTF8", "--locale=C"],
                       check=True, stdout=subprocess.DEVNULL, cwd=self.folder, user=self.user)
        self.process = None
        self.start()

    def start(self):
        with open(os.path.join(self.folder, "log"), "ab") as log:
            self.process = subprocess.Popen(
                [self.programs + "/postgres", "-D", self.data, "-k", self.folder, "-c", "listen_addresses="],
                stdin=subprocess.DEVNULL, stdout=log, stderr=log, cwd=self.folder, user=self.user)
        for _ in range(600):
            if subprocess.run([self.programs + "/pg_isready", "-q", "-h", self.folder], check=False).returncode == 0:
                return
            if self.process.poll() is not None:
                self.process = None
                time.sleep(0.2)
                return self.start()
            time.sleep(0.05)
        raise SystemExit("the server does not begin")

    def kill(self):
        """As a loss of power would: every process of it at once, the first one first."""
        first = self.process.pid
        with open(f"/proc/{first}/task/{first}/children", encoding="ascii") as children:
            others = [int(child) for child in children.read().split()]
        for pid in [first] + others:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.process.wait()

    def end(self):
        self.process.send_signal(signal.SIGINT)
        self.process.wait()
        shutil.rmtree(self.folder)

    def address(self, database):
        return f"postgresql://postgres@/{database}?host={self.folder}"

    def psql(self, database, statement):
        done = subprocess.run([self.programs + "/psql", "-XqAt", self.address(database), "-c", statement],
                              check=True, capture_output=True, text=True)
        return done.stdout


def boxes(count, folder):
    """A placement of that many cubes, their faces side by side from the first row on."""
    profile = os.path.join(folder, "profile.json")
    with open(profile, "w", encoding="utf-8") as file:
        file.write(checked("profile", "--q", "4", "--polynomial", "2,1,0,0,0,0,0,0,0,0,0,1", "--shape", "2047x2049", "--window", "3x4"))
    with open(profile, encoding="utf-8") as file:
        array = json.load(file)
    vertices = [{"name": f"V{i + 1}", "at": [str(127 * c) for c in corner]} for i, corner in enumerate(CORNERS)]
    objects, layings = [], []
    for i in range(count):
        name = f"box{i:05d}"
        objects.append({"schema": "pra-tactile/object/1", "name": name, "vertices": vertices, "faces": FACES})
        for j, face in enumerate(FACES):
            row, column = divmod(6 * i + j, 409)
            layings.append({"object": name, "face": face, "row": 4 * row, "column": 5 * column, "margin_mm": None,
                            "cells": ["#####"] * 4})
    placement = os.path.join(folder, "boxes.json")
    with open(placement, "w", encoding="utf-8") as file:
        json.dump({"schema": "pra-tactile/placement/1", "profile": array, "pitch_mm": ["25.4", "31.75"], "objects": objects,
                   "layings": layings}, file)
    return placement


def batch(database, positions):
    """The answers, and how long each took, in milliseconds, with what the pipes take."""
    process = subprocess.Popen([PROGRAM, "objects", "--database", database, "--batch"], stdin=subprocess.PIPE,
                               stdout=subprocess.PIPE, text=True, bufsize=1)
    answers, times = [], []
    for row, column in positions:
        begin = time.perf_counter()
        process.stdin.write(f"{row},{column}\n")
        process.stdin.flush()
        answers.append(process.stdout.readline())
        times.append(1000 * (time.perf_counter() - begin))
    process.stdin.close()
    process.wait()
    return answers, times


def large(server, arguments, folder):
    placement = boxes(arguments.boxes, folder)
    file = os.path.join(folder, "boxes.sqlite")
    server.psql("postgres", "CREATE DATABASE boxes")
    there = server.address("boxes")
    for database in [file, there]:
        kind = "in a file" if database == file else "on a server"
        begin = time.perf_counter()
        checked("objects", "--placement", placement, "--write", database)
        print(f"{kind}: {arguments.boxes} boxes stored in {time.perf_counter() - begin:.1f} s", flush=True)
        begin = [time.perf_counter()]
        for _ in range(11):
            checked("objects", "--database", database, "--at", "6,5")
            begin.append(time.perf_counter())
        print(f"{kind}: opened and asked once in {1000 * statistics.median(b - a for a, b in zip(begin, begin[1:])):.0f} ms", flush=True)
    draw = random.Random(7)
    positions = [(draw.randrange(620), draw.randrange(2049)) for _ in range(arguments.positions)]
    ours, times = batch(file, positions)
    print(f"in a file: a look-up in {statistics.median(times):.2f} ms (median of {len(times)})", flush=True)
    theirs, times = batch(there, positions)
    print(f"on a server: a look-up in {statistics.median(times):.2f} ms (median of {len(times)})", flush=True)
    same = sum(a == b and a != "" for a, b in zip(ours, theirs))
    print(f"the same answer at {same} of {len(positions)} positions", flush=True)
    tables = "metadata object vertex face corner edge laying band run".split()
    scans = server.psql("boxes", "SELECT relname, seq_scan, idx_scan FROM pg_stat_user_tables ORDER BY relname")
    print("scans of tables, of indexes: " + "; ".join(line.replace("|", " ") for line in scans.split("\n") if line.split("|")[0] in tables))
    begin = time.perf_counter()
    checked("objects", "--database", there, "--add", "another=box:127x127x127")
    print(f"on a server: a box added in {time.perf_counter() - begin:.1f} s", flush=True)


FEWER, MORE = "2 objects, 12 faces on 228 of 255 cells\n", "3 objects, "


def whole(database, outcomes):
    """What a check says; the added object is removed again."""
    done = pra("objects", "--database", database, "--check")
    if done.returncode != 0 or not (done.stdout == FEWER or done.stdout.startswith(MORE)):
        outcome = "LOST: " + (done.stdout + done.stderr).strip()
    elif done.stdout == FEWER:
        outcome = "as before"
    else:
        outcome = "changed"
        checked("objects", "--database", database, "--remove", "lid")
    outcomes[outcome] = outcomes.get(outcome, 0) + 1


def adding(database, name="lid", shape="box:60x30x40"):
    return subprocess.Popen([PROGRAM, "objects", "--database", database, "--add", f"{name}={shape}"],
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def kills(server, count, of_server):
    database = server.address("small")
    draw = random.Random(3)
    begin = time.perf_counter()
    adding(database).wait()
    usual = time.perf_counter() - begin
    checked("objects", "--database", database, "--remove", "lid")
    outcomes, said = {}, {}
    for _ in range(count):
        process = adding(database)
        time.sleep(draw.uniform(0, 1.3 * usual))
        if of_server:
            server.kill()
            error = process.communicate()[1].strip().replace(database, "DATABASE")
            key = f"{process.returncode}: {error or 'done'}"
            said[key] = said.get(key, 0) + 1
            server.start()
        else:
            process.kill()
            process.communicate()
        whole(database, outcomes)
    print(f"{count} kills of the {'server' if of_server else 'client'}: {outcomes}", flush=True)
    for line, times in said.items():
        print(f"  {times} times {line}", flush=True)


def writers(server, rounds):
    database = server.address("small")
    outcomes = {}
    for _ in range(rounds):
        both = [adding(database, name, "box:30x30x40") for name in "ab"]
        ends = [(process.communicate()[1].strip(), process.returncode) for process in both]
        names = [name for name, end in zip("ab", ends) if end[1] == 0]
        check = pra("objects", "--database", database, "--check")
        kept = check.stdout.startswith(f"{2 + len(names)} objects, ") and check.returncode == 0
        key = f"{len(names)} done, {'all' if kept else 'NOT ALL'} kept, said {sorted({end[0] for end in ends if end[0]})}"
        outcomes[key] = outcomes.get(key, 0) + 1
        if names:
            checked("objects", "--database", database, "--remove", *names)
    print(f"{rounds} rounds of two writers: {outcomes}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    for name, usual in [("boxes", 10000), ("positions", 100000), ("kills", 1000), ("server-kills", 100), ("rounds", 1000)]:
        parser.add_argument("--" + name, type=int, default=usual)
    arguments = parser.parse_args()
    # Where it is ended, the server ends too.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    server = Server()
    try:
        with tempfile.TemporaryDirectory() as folder:
            if arguments.boxes:
                large(server, arguments, folder)
            server.psql("postgres", "CREATE DATABASE small")
            checked("objects", "--write", server.address("small"))
            writers(server, arguments.rounds)
            kills(server, arguments.kills, False)
            kills(server, arguments.server_kills, True)
    finally:
        server.end()


if __name__ == "__main__":
    main()
