#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The questions of the first page run as printed, each in one line, and give what is right by hand."""

import json
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

    def test_two_lamps(self):
        # 60 W of a point: 60 / (4 pi d^2) on a plane that faces it. The plate hides one of them from the second point.
        write("plate.stl", box(-0.9, -0.7, -0.2, 0.2, 0.9, 1.1))
        answer = self.ask("How much light comes", points=[[0, 0, 0], [-0.8, 0, 0]])
        each = 60.0 / (4.0 * math.pi) * 3.0
        np.testing.assert_allclose(answer.sum(axis=1), [2.0 * each / 10.0 ** 1.5, each / (9.0 + 1.8 ** 2) ** 1.5], rtol=1e-4)

    def test_fluence(self):
        # 15 W of a sphere: radiance L = 15 / (pi 4 pi r^2), and L times its solid angle at distance d.
        write("room.stl", box(-3, 3, -3, 3, 0, 3))
        write("pillar.stl", box(0.9, 1.1, -0.1, 0.1, 0, 3))
        answer = self.ask("How much passes", points=[[-1, 0, 1], [2, 0, 1]])
        solid_angle = 2.0 * math.pi * (1.0 - math.sqrt(1.0 - 0.05 ** 2 / (1.0 + 1.5 ** 2)))
        radiance = 15.0 / (math.pi * 4.0 * math.pi * 0.05 ** 2)
        np.testing.assert_allclose(answer.sum(axis=1), [radiance * solid_angle, 0.0], rtol=1e-4)

    def test_sun_hours(self):
        # Equinox in Munich: above the horizon for half a day, always in the south. A roof hides all of it, a facade to the north too.
        write("house.stl", box(-500, 500, 0, 9, 0, 500))
        answer = self.ask("How many hours", points=[[0, -0.1, 250], [0, 9.1, 250], [0, 4, 10]])
        self.assertAlmostEqual(float(answer[0]), 12.0, delta=0.4)
        self.assertLess(float(answer[1]), 0.5)
        self.assertEqual(float(answer[2]), 0.0)

    def test_width(self):
        # The edge is 4 above the ground: 4 sqrt 2 away along the light. 80.545 % of the Sun's angle, stretched by 1 / sin 45.
        write("house.stl", box(-9, 9, 0, 1, 0, 4))
        points = [[0, 5 + x, 0] for x in np.linspace(-0.02, 0.02, 5)]
        answer = self.ask("How wide is", points=points)
        right = 0.80545 * math.radians(0.533) * 4.0 * math.sqrt(2.0) * math.sqrt(2.0)
        self.assertAlmostEqual(float(answer[2]), right, delta=0.05 * right)

    def test_footprints(self):
        write("ground.stl", square(20, 0.0))
        write("house.stl", box(-1, 1, 0, 1, 0, 4))
        write("tree.stl", box(5, 6, 0, 1, 0, 2))
        self.ask("Where does it lie")
        with open("shadow.geojson", encoding="utf-8") as file:
            features = json.load(file)["features"]
        names = {feature["properties"]["OccluderName"] for feature in features}
        self.assertEqual(names, {"house", "tree"})
        # The house hides 2 x 1 under it and 2 x 4 behind it, and half of a fringe of 0.07 more.
        whole = [f["properties"]["Area"] for f in features
                 if f["properties"]["OccluderName"] == "house" and f["properties"]["ShadowClass"] == 1]
        self.assertAlmostEqual(sum(whole), 10.0, delta=0.6)

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
