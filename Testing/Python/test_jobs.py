#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The questions of the first page run as printed, each in one line, and give what is right by hand."""

import math
import os
import re
import tempfile
import unittest

import numpy as np
import shadowcones as sc
from shadowcones import _meshes
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter

PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Documentation", "1-getting-started.md")


def jobs():
    """Question to line of Python, from the table of the page."""
    with open(PAGE, encoding="utf-8") as page:
        section = page.read().split("## Ask in one line\n")[1].split("\n## ")[0]
    return dict(re.findall(r"^\| (.*?) \| `(.*)` \|$", section, re.MULTILINE))


def write(name, mesh):
    triangles = vtkTriangleFilter()  # STL has nothing else
    triangles.SetInputData(mesh)
    writer = vtkSTLWriter()
    writer.SetInputConnection(triangles.GetOutputPort())
    writer.SetFileName(name)
    writer.Write()


def box(x0, x1, y0, y1, z0, z1):
    source = vtkCubeSource()
    source.SetBounds(x0, x1, y0, y1, z0, z1)
    source.Update()
    return source.GetOutput()


def square(half, z):
    return _meshes.polydata_of([[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]], [[0, 1, 2, 3]])


class Jobs(unittest.TestCase):
    jobs = jobs()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)

    def ask(self, begin, **names):
        lines = [code for question, code in self.jobs.items() if question.startswith(begin)]
        self.assertEqual(len(lines), 1, begin)
        self.tried.add(begin)
        return eval(lines[0].replace('light_shafts("part.stl")', 'light_shafts("part.stl", size=(48, 36))'), {"sc": sc, **names})

    tried = set()

    @classmethod
    def tearDownClass(cls):
        lacking = [question for question in cls.jobs if not any(question.startswith(begin) for begin in cls.tried)]
        assert not lacking, f"no test asks: {lacking}"

    def part(self):
        sphere = vtkSphereSource()
        sphere.SetThetaResolution(32)
        sphere.SetPhiResolution(16)
        sphere.Update()
        write("part.stl", sphere.GetOutput())

    def test_shafts(self):
        self.part()
        self.ask("What do the light shafts")
        with open("shafts.png", "rb") as picture:
            self.assertEqual(picture.read(4), b"\x89PNG")

    def test_umbra(self):
        # Disc of radius 0.5 at 4, plate of half width 1: at depth 2 the umbra reaches to 1 + (1 - 0.5) * 2 / 4.
        write("plate.stl", square(1.0, 0.0))
        answer = self.ask("Which of these points", points=[[0, 0, -2], [1.24, 0, -2], [1.26, 0, -2], [3, 0, -2]])
        self.assertEqual(answer.tolist(), [True, True, False, False])

    def test_whose(self):
        # From the south at 45 degrees: shadows run north as far as things are high.
        write("house.stl", box(-1, 1, 0, 1, 0, 4))
        write("tree.stl", box(5, 6, 0, 1, 0, 2))
        answer = self.ask("Whose shadow", points=[[0, 4.9, 0], [5.5, 2.9, 0], [5.5, 3.1, 0], [0, -1, 0]])
        self.assertEqual(answer.tolist(), ["house", "tree", "", ""])

    def test_solid(self):
        self.part()
        self.ask("Which solid")
        self.assertGreater(os.path.getsize("shadow.stl"), 1000)

    def test_eclipse(self):
        # The Moon as its outline, 384,400 km before the observer: radii as seen decide. Beyond the tip of the umbra a ring is left.
        angles = np.linspace(0.0, 2.0 * math.pi, 2000, endpoint=False)
        radius, sun, distance = 1737.4, 695700.0, 149597870.0
        outline = np.stack([0 * angles, radius * np.cos(angles), radius * np.sin(angles)], axis=1)
        moon = (outline, [np.arange(2000)])
        tip = radius * distance / (sun - radius)  # of the umbra behind a disc at the origin
        points = [[0.995 * tip, 0, 0], [1.1 * tip, 0, 0], [1.1 * tip, 30000, 0]]
        answer = self.ask("How much of the Sun", points=points, moon=moon)
        self.assertEqual(answer[0], 0.0)
        # Seen from afar the Sun is the disc of the circle that bounds it, of angular radius asin(R / d).
        x = 1.1 * tip
        ring = 1.0 - (math.atan(radius / x) / math.asin(sun / (distance + x))) ** 2
        self.assertAlmostEqual(answer[1], ring, delta=0.03)
        self.assertEqual(answer[2], 1.0)


if __name__ == "__main__":
    unittest.main()
