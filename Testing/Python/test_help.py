#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every example says with --help what it does, and is run by a test: test_help.py FOLDER CMAKELISTS."""

import contextlib
import io
import os
import runpy
import sys
import unittest
import unittest.mock

FOLDER, LISTS = sys.argv[1:3]
# Imported by the others.
SHARED = {"by_hand.py", "common.py", "cone_sets.py", "diagrams.py", "drawing.py", "scenes.py"}


def examples():
    return sorted(name for name in os.listdir(FOLDER) if name.endswith(".py") and name not in SHARED)


def help_of(name):
    """What an example prints with --help, and its exit status. It runs in this process, which has loaded VTK already."""
    printed = io.StringIO()
    path = os.path.join(FOLDER, name)
    with unittest.mock.patch.object(sys, "argv", [path, "--help"]), contextlib.redirect_stdout(printed):
        try:
            runpy.run_path(path, run_name="__main__")
            status = 0
        except SystemExit as end:
            status = end.code
    return printed.getvalue(), status


class Help(unittest.TestCase):
    def test_help(self):
        sys.path.insert(0, FOLDER)
        for name in examples():
            with self.subTest(name):
                text, status = help_of(name)
                self.assertIn(status, (0, None), text)
                self.assertIn("--output", text)
                self.assertIn("default:", text)

    def test_every_example_is_run(self):
        with open(LISTS, encoding="utf-8") as file:
            lists = file.read()
        for name in examples():
            self.assertIn(f"add_example({name[:-3]} ", lists)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
