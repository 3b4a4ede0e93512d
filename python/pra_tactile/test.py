"""The package as its users have it: python -m unittest pra_tactile.test"""

import array
import contextlib
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import pra_tactile
from pra_tactile import Failed, Refused

try:
    import numpy
except ImportError:
    numpy = None

# Four symbols of the paper's array, the worked example's window, and the frames that show it.
WINDOW = [[3, 2], [3, 1]]


def pressed(folder, *options):
    """A folder of simulated frames in their own form, and what they show."""
    path = os.path.join(folder, "frames")
    asked = ["probe", "--object", "cube", "--seed", "7", "--output", path, *options]
    subprocess.run([pra_tactile.program(), *asked], check=True, stdout=subprocess.DEVNULL)
    return path, pra_tactile.decode(path)


def frames_of(path):
    """Each frame of a folder as (rows, x, y, rotation), and its full scale."""
    with open(os.path.join(path, "manifest.csv")) as manifest:
        names, *lines = [line.split(",") for line in manifest.read().split()]
    for line in lines:
        told = dict(zip(names, line))
        with open(os.path.join(path, told["file"]), "rb") as file:
            header, readings = re.fullmatch(rb"P5\n(\d+) \d+\n255\n(.*)", file.read(), re.S).groups()
        side = int(header)
        rows = [list(readings[i : i + side]) for i in range(0, len(readings), side)]
        yield rows, float(told["x_mm"]), float(told["y_mm"]), float(told["rotation_deg"])


class Decoding(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path, cls.answer = pressed(cls.folder.name)
        cls.frames = list(frames_of(cls.path))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def assert_same(self, answer):
        for key in self.answer:
            if key not in ("source", "sources"):
                self.assertEqual(answer.get(key), self.answer[key], key)

    def test_a_folder(self):
        self.assertEqual(self.answer["outcome"], "located")

    def test_lists_of_rows(self):
        self.assert_same(pra_tactile.decode(self.frames, full_scale=255))

    def test_shares_of_full_scale(self):
        shares = [([[v / 255 for v in row] for row in rows], *pose) for rows, *pose in self.frames]
        self.assertEqual(pra_tactile.decode(shares)["message"], self.answer["message"])

    def test_buffers(self):
        for letter in "BHhif":
            with self.subTest(letter):
                frames = []
                for rows, *pose in self.frames:
                    flat = array.array(letter, [v for row in rows for v in row])
                    view = memoryview(flat).cast("B").cast(letter, [len(rows), len(rows[0])])
                    frames.append((view, *pose))
                self.assert_same(pra_tactile.decode(frames, full_scale=255))

    @unittest.skipUnless(numpy, "numpy is not installed")
    def test_arrays_of_numpy(self):
        for kind in ("u1", ">u2", "<i4", "<i8", "<f4", ">f8"):
            with self.subTest(kind):
                frames = [(numpy.array(rows, dtype=kind), *pose) for rows, *pose in self.frames]
                self.assert_same(pra_tactile.decode(frames, full_scale=255))
        turned = [(numpy.array(rows, dtype="u1").T.copy().T, *pose) for rows, *pose in self.frames]
        self.assert_same(pra_tactile.decode(turned))

    def test_a_blank_image_is_a_refusal(self):
        blank = [[0.0] * 40 for _ in range(52)]
        self.assertNotEqual(pra_tactile.decode(blank)["outcome"], "located")

    def test_what_is_no_image(self):
        for image in ([], [[]], [[1], [1, 2]], [[255]], bytearray(4)):
            with self.subTest(image), self.assertRaises(ValueError):
                pra_tactile.decode(image)
        with self.assertRaises(ValueError):
            pra_tactile.decode([([[0.5]], 1)])
        with self.assertRaises(Failed):
            pra_tactile.decode("no/such/folder")

    def test_no_temporary_folder_is_needed(self):
        with mock.patch.dict(os.environ, {"TMPDIR": "/nowhere"}), mock.patch.object(tempfile, "tempdir", "/nowhere"):
            if hasattr(os, "memfd_create"):
                self.assert_same(pra_tactile.decode(self.frames, full_scale=255))


class Locating(unittest.TestCase):
    def test_a_window_is_found(self):
        self.assertEqual(pra_tactile.locate(WINDOW)["position"], {"row": 6, "column": 5})
        self.assertEqual(pra_tactile.locate("3 2 / 3 1")["position"], {"row": 6, "column": 5})

    def test_refusals_are_answers(self):
        self.assertEqual(pra_tactile.locate([[0, 0], [0, 0]])["reason"], "zero-window")
        self.assertEqual(pra_tactile.locate([[3, None]])["outcome"], "ambiguous")
        self.assertEqual(pra_tactile.locate([[3, 9]])["outcome"], "invalid")

    def test_every_window_of_the_array(self):
        rows = pra_tactile.array()
        for i in range(15):
            for j in range(17):
                window = [[rows[(i + r) % 15][(j + c) % 17] for c in range(2)] for r in range(2)]
                self.assertEqual(pra_tactile.locate(window)["position"], {"row": i, "column": j})

    def test_options_have_processes_of_their_own(self):
        rows = pra_tactile.array()
        across = [[rows[14][16], rows[14][0]], [rows[0][16], rows[0][0]]]
        for surface, outcome in (("torus", "located"), ("sheet", "refused")) * 6:
            self.assertEqual(pra_tactile.locate(across, surface=surface)["outcome"], outcome)
        with self.assertRaises(Failed) as caught:
            pra_tactile.locate(WINDOW, surface="mobius")
        self.assertEqual(caught.exception.status, 2)
        with self.assertRaises(ValueError):
            pra_tactile.locate("3 2\n3 1")

    def test_a_killed_process_is_a_fault_and_the_next_question_is_answered(self):
        pra_tactile.locate(WINDOW)
        for one in pra_tactile._asked.values():
            one.process.send_signal(signal.SIGKILL)
            one.process.wait()
        with self.assertRaises(Failed):
            pra_tactile.locate(WINDOW)
        self.assertEqual(pra_tactile.locate(WINDOW)["outcome"], "located")

    def test_a_forked_child_asks_a_process_of_its_own(self):
        pra_tactile.locate(WINDOW)
        child = os.fork()
        if child == 0:
            right = False
            with contextlib.suppress(BaseException):
                right = all(pra_tactile.locate(WINDOW)["outcome"] == "located" for _ in range(100))
            os._exit(0 if right else 1)
        self.assertTrue(all(pra_tactile.locate(WINDOW)["outcome"] == "located" for _ in range(100)))
        self.assertEqual(os.waitpid(child, 0)[1], 0)

    def test_a_missing_program_is_told(self):
        with mock.patch.dict(os.environ, {"PATH": "", "PRA_TACTILE": ""}):
            with mock.patch.object(os.path, "isfile", lambda path: False), self.assertRaises(Failed):
                pra_tactile.run("profile")


class Arrays(unittest.TestCase):
    def test_the_papers(self):
        rows = pra_tactile.array()
        self.assertEqual(pra_tactile.array(q=4, shape=(15, 17)), rows)
        self.assertEqual([rows[6][5:7], rows[7][5:7]], WINDOW)

    def test_each_nonzero_window_occurs_once(self):
        for q, shape, window in ((2, (3, 5), (2, 2)), (2, (7, 9), (3, 2)), (3, (2, 13), (1, 3))):
            rows = pra_tactile.array(q=q, shape=shape)
            windows = {
                tuple(
                    rows[(i + r) % shape[0]][(j + c) % shape[1]]
                    for r in range(window[0])
                    for c in range(window[1])
                )
                for i in range(shape[0])
                for j in range(shape[1])
            }
            self.assertEqual(len(windows), shape[0] * shape[1])

    def test_an_impossible_shape(self):
        with self.assertRaises(Failed):
            pra_tactile.array(q=4, shape=(15, 18))


def add(a, b):
    """In GF(4), whose codes are pairs of bits."""
    if not all(type(x) is int and 0 <= x < 4 for x in (a, b)):
        raise Refused("invalid")
    return a ^ b


class Conforming(unittest.TestCase):
    def laws(self, report, outcome):
        return {law["law"] for law in report["laws"] if law["outcome"] == outcome}

    def test_what_is_right_is_certified(self):
        report = pra_tactile.conform({"add": add, "negate": lambda a: add(a, 0)}, stage="field")
        self.assertEqual(self.laws(report, "failed"), set())
        self.assertIn("field/addition-as-defined", self.laws(report, "held"))

    def test_what_is_wrong_is_found(self):
        wrong = {"add": lambda a, b: (a + b) % 4}
        report = pra_tactile.conform(wrong, stage="field")
        self.assertIn("field/addition-as-defined", self.laws(report, "failed"))
        self.assertFalse(report["certified"])

    def test_what_raises_errs_and_what_is_no_json_errs(self):
        for wrong in (lambda a, b: 1 // 0, lambda a, b: object(), lambda a, b: float("nan")):
            report = pra_tactile.conform({"add": wrong}, stage="field", run="field/addition-as-defined")
            self.assertFalse(report["certified"])

    def test_what_hangs_times_out(self):
        def hangs(a, b):
            time.sleep(1000)

        report = pra_tactile.conform({"add": hangs}, run="field/addition-as-defined", timeout=0.5)
        self.assertEqual(self.laws(report, "errored"), {"field/addition-as-defined"})

    def test_profiles_are_put_in_force(self):
        known = {}

        def profile(profile):
            known.update(profile)

        def negate(a):
            if type(a) is not int or not 0 <= a < known["q"]:
                raise Refused("invalid")
            return -a % known["q"] if known["q"] in (3, 5, 7) else a

        given = pra_tactile.run("profile", json=None, q=3, polynomial=[1, 2, 0, 1], shape=(2, 13))
        report = pra_tactile.conform({"negate": negate, "profile": profile}, profile=given, stage="field")
        self.assertEqual(known["q"], 3)
        self.assertEqual(self.laws(report, "failed"), set())


if __name__ == "__main__":
    unittest.main()
