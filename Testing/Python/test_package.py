#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The package 'shadowcones': every class is there, has its help, prints itself, and takes its parameters."""

import os
import re
import subprocess
import sys
import unittest

import shadowcones as sc
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

MODULES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Modules")


def class_names():
    """Every class of a wrapped module that its list calls no helper, which is one without ports."""
    for module in ("Sources", "Filters", "Imaging"):
        with open(os.path.join(MODULES, module, "CMakeLists.txt"), encoding="utf-8") as lists:
            classes = re.search(r"set\(classes([^)]*)\)", lists.read()).group(1).split()
        yield from classes


# Documented together with the parameter before it, which VTK's help does not show.
GROUPED = {"Height"}
CLASSES = sorted(class_names())


def parameters(name):
    """What the class itself adds that has a setter and a getter without arguments."""
    own = getattr(sc, name).__dict__
    instance = getattr(sc, name)()
    for method in own:
        if method.startswith("Set") and "Get" + method[3:] in own and not method.endswith("Spectrum"):
            yield instance, method[3:], getattr(instance, "Get" + method[3:])()


class Package(unittest.TestCase):
    def test_classes_are_found(self):
        self.assertGreaterEqual(len(CLASSES), 6)

    def test_version(self):
        self.assertRegex(sc.__version__, r"^\d+\.\d+\.\d+$")

    def test_every_class_is_an_algorithm(self):
        for name in CLASSES:
            with self.subTest(name):
                self.assertIsInstance(getattr(sc, name)(), vtkAlgorithm)

    def test_help(self):
        for name in CLASSES:
            with self.subTest(name):
                text = getattr(sc, name).__doc__
                self.assertRegex(text, rf"{name} - \w+")
                self.assertRegex(text, r"[Oo]utput")

    def test_help_of_parameters(self):
        for name in CLASSES:
            for instance, parameter, _ in parameters(name):
                if parameter in GROUPED:
                    continue
                with self.subTest(f"{name}.{parameter}"):
                    # After the signature: what it means, and the default.
                    text = getattr(instance, "Set" + parameter).__doc__.split("\n\n", 1)[1]
                    self.assertGreater(len(text.split()), 3)
                    self.assertIn("default", text.lower())

    def test_parameters_are_found(self):
        self.assertGreaterEqual(sum(1 for name in CLASSES for _ in parameters(name)), 40)

    def test_print(self):
        for name in CLASSES:
            for instance, parameter, _ in parameters(name):
                with self.subTest(f"{name}.{parameter}"):
                    self.assertIn(parameter, str(instance))

    def test_set_and_get(self):
        for name in CLASSES:
            for instance, parameter, value in parameters(name):
                if isinstance(value, (bool, int, float)):
                    with self.subTest(f"{name}.{parameter}"):
                        other = not value if isinstance(value, bool) else value + 1
                        time = instance.GetMTime()
                        getattr(instance, "Set" + parameter)(other)
                        self.assertEqual(getattr(instance, "Get" + parameter)(), other)
                        self.assertGreater(instance.GetMTime(), time)

    def test_import_needs_no_display(self):
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        subprocess.run([sys.executable, "-c", "import shadowcones"], env=environment, check=True)


if __name__ == "__main__":
    unittest.main()
