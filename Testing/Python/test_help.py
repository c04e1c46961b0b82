#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every example says with --help what it does, and is run by a test: test_help.py FOLDER CMAKELISTS."""

import os
import subprocess
import sys
import unittest

FOLDER, LISTS = sys.argv[1:3]
# Imported by the others.
SHARED = {"common.py", "cone_sets.py", "drawing.py", "scenes.py"}


def examples():
    return sorted(name for name in os.listdir(FOLDER) if name.endswith(".py") and name not in SHARED)


class Help(unittest.TestCase):
    def test_help(self):
        for name in examples():
            with self.subTest(name):
                command = [sys.executable, os.path.join(FOLDER, name), "--help"]
                result = subprocess.run(command, text=True, capture_output=True)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn("--output", result.stdout)
                self.assertIn("default:", result.stdout)

    def test_every_example_is_run(self):
        with open(LISTS, encoding="utf-8") as file:
            lists = file.read()
        for name in examples():
            self.assertIn(f"add_example({name[:-3]} ", lists)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
