# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the command share: running it in a folder of its own, and small meshes as files."""

import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else "shadowcones"

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def box(low, high):
    """The text of an OBJ file: a closed box."""
    points = [tuple(low[axis] if corner[axis] == 0 else high[axis] for axis in range(3)) for corner in CORNERS]
    lines = [f"v {x} {y} {z}" for x, y, z in points]
    lines += ["f " + " ".join(str(index + 1) for index in face) for face in FACES]
    return "\n".join(lines) + "\n"


class ProgramTest(unittest.TestCase):
    """A test that runs the command in an empty folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def command(self, *words):
        return [PROGRAM, *map(str, words)]

    def run_program(self, *words):
        """Exit code, standard output and standard error."""
        done = subprocess.run(self.command(*words), cwd=self.folder, capture_output=True, text=True, timeout=250)
        return done.returncode, done.stdout, done.stderr

    def answer(self, *words):
        """The rows of a table on standard output, by the names in its first line."""
        code, out, error = self.run_program(*words)
        self.assertEqual(code, 0, error)
        lines = [line.split(",") for line in out.strip().split("\n")]
        return [dict(zip(lines[0], line)) for line in lines[1:]]
