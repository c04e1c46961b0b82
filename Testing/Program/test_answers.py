#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Ten questions of the command line, each held against a value that is known without it."""

import json
import math
import os
import struct
import unittest

from program import ProgramTest, box

DOWN = "sun: direction 0,0,-1 diameter 0"


class AnswerTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", box((-1, -1, 2), (1, 1, 4)))
        self.write("far.obj", box((50, 50, 2), (51, 51, 4)))

    def test_image(self):
        code, _, error = self.run_program("image", "cube.obj", "--size", "40x30", "--error", 0.1, "-o", "a.png", "-q")
        self.assertEqual((code, error), (0, ""))
        with open(self.path("a.png"), "rb") as file:
            self.assertEqual(struct.unpack(">II", file.read(24)[16:]), (40, 30))
        self.assertEqual(sorted(os.listdir(self.folder)), ["a.png", "cube.obj", "far.obj"])

    def test_probe(self):
        rows = self.answer("probe", "cube.obj", "--light", DOWN, "--at", "0,0,0", "--at", "3,0,0", "-q")
        self.assertEqual([(row["Visibility"], row["ShadowClass"], row["OccluderId"]) for row in rows],
                         [("0", "2", "0"), ("1", "0", "-1")])

    def test_shadow_of(self):
        code, out, _ = self.run_program("shadow-of", "cube.obj", "far.obj", "--light", DOWN, "--at", "0,0,0", "--at", "50.5,50.5,0",
                                        "--at", "9,9,0", "-q")
        self.assertEqual((code, out), (0, "cube\nfar\n\n"))

    def test_irradiance(self):
        """A disc above a parallel element: pi L R^2 / (h^2 + R^2)."""
        rows = self.answer("irradiance", "far.obj", "--light", "disc:0,0,2", "radius", 1, "facing", "0,0,-1", "--at", "0,0,0",
                           "--facing", "0,0,1", "-q")
        self.assertAlmostEqual(float(rows[0]["Irradiance:0"]), math.pi / 5, delta=1e-3)

    def test_fluence(self):
        """A sphere of radiance 1: its solid angle."""
        rows = self.answer("fluence", "far.obj", "--light", "sphere:0,0,2", "radius", 1, "--at", "0,0,0", "-q")
        self.assertAlmostEqual(float(rows[0]["FluenceRate:0"]), 2 * math.pi * (1 - math.sqrt(0.75)), delta=2e-3)

    def test_widths(self):
        """Below a straight edge the share of a disc beyond a chord: 5 % and 95 % of its area lie 0.8054 radii from the middle."""
        self.write("plate.obj", "v 0 -50 3\nv 100 -50 3\nv 100 50 3\nv 0 50 3\nf 1 2 3 4\n")
        code, _, error = self.run_program("widths", "plate.obj", "--light", "sun: direction 0,0,-1 diameter 2", "--ground", "0,0.2,5",
                                          "-q", "-o", "widths.vtp")
        self.assertEqual(code, 0, error)
        self.write("line.obj", "v -1 0 0\nv 1 0 0\nv 1 0.01 0\nv -1 0.01 0\nf 1 2 3 4\n")
        rows = self.answer("widths", "plate.obj", "--light", "sun: direction 0,0,-1 diameter 2", "--where", "line.obj", "-q")
        for row in rows:
            self.assertAlmostEqual(float(row["PenumbraWidth"]), 2 * 0.8054 * 3 * math.tan(math.radians(1)), delta=4e-3)

    def test_footprints(self):
        """A post of 2 x 2 x 2 with its foot 2 above the ground, and the Sun straight above: 4 square units."""
        code, _, error = self.run_program("footprints", "cube.obj", "--light", DOWN, "--up", "z", "--ground", "0,6,61", "-o", "a.geojson", "-q")
        self.assertEqual(code, 0, error)
        with open(self.path("a.geojson"), encoding="utf-8") as file:
            features = json.load(file)["features"]
        self.assertEqual(len(features), 1)
        self.assertAlmostEqual(features[0]["properties"]["Area"], 4.0, delta=0.02)

    def test_solids(self):
        """Below the cube as far as the box: 2 x 2 x 2."""
        code, _, error = self.run_program("solids", "cube.obj", "--light", DOWN, "--method", "projection", "--bounds=-3,3,-3,3,0,2",
                                          "-o", "a.stl", "-q")
        self.assertEqual(code, 0, error)
        self.assertAlmostEqual(self.volume("a.stl"), 8.0, delta=0.01)

    def volume(self, name):
        """Of an STL file, by its signed tetrahedra."""
        with open(self.path(name), "rb") as file:
            data = file.read()
        if data[:5] == b"solid":
            numbers = [tuple(map(float, line.split()[1:])) for line in data.decode().split("\n") if "vertex" in line]
        else:
            numbers = [struct.unpack_from("<3f", data, 84 + 50 * face + 12 * corner)
                       for face in range(struct.unpack_from("<I", data, 80)[0]) for corner in (1, 2, 3)]
        total = 0.0
        for a, b, c in zip(numbers[0::3], numbers[1::3], numbers[2::3]):
            total += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
        return total

    def test_eclipse(self):
        """Beside the middle of the Moon's shadow the overlap of two discs, and behind the tip of its umbra a ring of Sun."""
        moon, distance, sun = 1737.4, 149597870.0, 695700.0
        rows, columns = 120, 240
        lines = ["v %.9g %.9g %.9g" % (moon * math.cos(b) * math.cos(a), moon * math.cos(b) * math.sin(a), moon * math.sin(b))
                 for b in (math.pi * (row / rows - 0.5) for row in range(rows + 1))
                 for a in (2 * math.pi * column / columns for column in range(columns))]
        for row in range(rows):
            for column in range(columns):
                corners = [(row, column), (row, (column + 1) % columns), (row + 1, (column + 1) % columns), (row + 1, column)]
                lines.append("f " + " ".join(str(r * columns + c + 1) for r, c in corners))
        self.write("moon.obj", "\n".join(lines) + "\n")
        places = [(370000.0, 0.0), (370000.0, 1500.0), (395000.0, 0.0), (370000.0, 3000.0)]
        answers = self.answer("probe", "moon.obj", "--light", f"sphere:{-distance},0,0", "radius", sun, "--samples", 16384, "-q",
                              *(word for x, y in places for word in ("--at", f"{x},{y},0")))
        for (x, y), row in zip(places, answers):
            a = math.asin(sun / math.hypot(x + distance, y))
            b = math.asin(moon / math.hypot(x, y))
            c = abs(math.atan2(y, x) - math.atan2(y, x + distance))
            self.assertAlmostEqual(float(row["Visibility"]), 1 - self.overlap(a, b, c) / (math.pi * a * a), delta=0.005)

    def overlap(self, a, b, c):
        """The area that two discs share, of radii a and b, whose middles are c apart."""
        if c >= a + b:
            return 0.0
        if c <= abs(a - b):
            return math.pi * min(a, b) ** 2
        first = math.acos((c * c + a * a - b * b) / (2 * c * a))
        second = math.acos((c * c + b * b - a * a) / (2 * c * b))
        return a * a * (first - math.sin(2 * first) / 2) + b * b * (second - math.sin(2 * second) / 2)

    def test_sun_hours(self):
        """At the equator on an equinox the Sun is up for 12 hours; beside a high wall in the east only after noon."""
        self.write("wall.obj", "v 1 -1000 -1\nv 1 1000 -1\nv 1 1000 1000\nv 1 -1000 1000\nf 1 2 3 4\n")
        where = ["--latitude", 0, "--longitude", 0, "--start", "2026-03-20", "--end", "2026-03-21", "--diameter", 0, "-q"]
        rows = self.answer("sun-hours", "far.obj", *where, "--at", "0,0,0")
        self.assertAlmostEqual(float(rows[0]["SunHours"]), 12.0, delta=0.2)
        rows = self.answer("sun-hours", "wall.obj", *where, "--at", "0,0,0")
        self.assertAlmostEqual(float(rows[0]["SunHours"]), 6.0, delta=0.3)

    def test_chain(self):
        code, _, error = self.run_program("vectors", "cube.obj", "--vectors", 300, "-o", "vectors.csv", "-q")
        self.assertEqual(code, 0, error)
        with open(self.path("vectors.csv"), encoding="utf-8") as file:
            self.assertGreater(len(file.readlines()), 300)
        code, out, _ = self.run_program("cones", "cube.obj", "--vectors", 600, "-o", "cones.vtp", "-q")
        self.assertEqual(code, 0)
        self.assertIn("proved", out)
        self.assertNotIn("not proved", out)
        code, out, _ = self.run_program("accuracy", "cube.obj", "--vectors", 600, "--samples", 2000, "-q")
        table = dict(line.split()[:2] for line in out.strip().split("\n"))
        self.assertEqual((code, table["Certified"], table["Recall"], table["Leak"]), (0, "1", "1", "0"))

    def test_page(self):
        code, _, error = self.run_program("page", "cube.obj", "--ground", "0,8,9", "-o", "a.html", "-q")
        self.assertEqual(code, 0, error)
        with open(self.path("a.html"), encoding="utf-8") as file:
            self.assertIn("Visibility", file.read())


if __name__ == "__main__":
    unittest.main(verbosity=2)
