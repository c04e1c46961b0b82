#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Light that arrives, edges of shadows and hours of Sun, in one line: right values by closed forms, faults as exceptions."""

import datetime
import math
import os
import tempfile
import unittest

import numpy as np
import shadowcones as sc
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource

NOTHING = ([[0, 0, 99], [1, 0, 99], [0, 1, 99]], [[0, 1, 2]])  # far above all lamps
HALF = ([[-100, -100, 0], [0, -100, 0], [0, 100, 0], [-100, 100, 0]], [[0, 1, 2, 3]])


def plate(half, z):
    return ([[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]], [[0, 1, 2, 3]])


class Irradiance(unittest.TestCase):
    def test_under_a_disc(self):
        # On the axis of a Lambertian disc: pi L R^2 / (R^2 + h^2).
        lamp = "disc:0,0,3 radius 1 facing -z radiance 1,2"
        found = sc.irradiance([[0, 0, 0], [0, 0, 1]], NOTHING, lamp, normals=(0, 0, 1))
        self.assertEqual(found.shape, (2, 2))
        right = math.pi / np.array([10.0, 5.0])
        np.testing.assert_allclose(found, np.outer(right, [1, 2]), rtol=1e-4)
        self.assertEqual(sc.irradiance([0, 0, 0], NOTHING, lamp, normals=(0, 0, 1)).shape, (2,))

    def test_lamps_add_up_and_one_is_hidden(self):
        lamps = ["point:-2,0,2 radiance 8", "point:2,0,2 radiance 8"]
        right = 8.0 / 8.0 * math.sqrt(0.5)  # one of them: distance sqrt 8, 45 degrees
        both = sc.irradiance([0, 0, 0], NOTHING, lamps, normals=(0, 0, 1))
        np.testing.assert_allclose(both, 2 * right, rtol=1e-5)
        wall = ([[-1, -9, 0], [-1, 9, 0], [-1, 9, 3], [-1, -9, 3]], [[0, 1, 2, 3]])
        np.testing.assert_allclose(sc.irradiance([0, 0, 0], wall, lamps, normals=(0, 0, 1)), right, rtol=1e-5)

    def test_flux_in_watts_comes_back(self):
        # A point of 60 W inside a sphere: 60 / (4 pi r^2) everywhere, in all wavelengths together.
        found = sc.irradiance([0, 0, 3], NOTHING, "point:0,0,0 flux 60 W", normals=(0, 0, -1))
        self.assertAlmostEqual(float(found.sum()), 60.0 / (4 * math.pi * 9), delta=1e-5)

    def test_data_sets_and_faults(self):
        plane = vtkPlaneSource()
        plane.Update()
        answer = sc.irradiance(plane.GetOutput(), NOTHING, "point:0,0,2")
        self.assertIsInstance(answer, vtkPolyData)
        self.assertEqual(answer.GetPointData().GetArray("Irradiance").GetNumberOfComponents(), 7)
        with self.assertRaisesRegex(ValueError, "normals are needed"):
            sc.irradiance([[0, 0, 0]], NOTHING, "point:0,0,2")
        with self.assertRaisesRegex(ValueError, "normals must be one vector"):
            sc.irradiance([[0, 0, 0]], NOTHING, "point:0,0,2", normals=[[1, 2]])
        with self.assertRaisesRegex(ValueError, "a data set carries its own"):
            sc.irradiance(plane.GetOutput(), NOTHING, "point:0,0,2", normals=(0, 0, 1))


class Fluence(unittest.TestCase):
    def test_under_a_disc(self):
        # Radiance times solid angle, 2 pi (1 - h / sqrt(h^2 + R^2)); half of it under a straight edge.
        lamp = "disc:0,0,3 radius 1 facing -z radiance 2 wavelengths 1"
        found = sc.fluence([[0, 0, 0], [0, 0, 1]], NOTHING, lamp)
        self.assertEqual(found.shape, (2, 1))
        heights = np.array([3.0, 2.0])
        np.testing.assert_allclose(found[:, 0], 4 * math.pi * (1 - heights / np.sqrt(heights ** 2 + 1)), rtol=1e-4)
        np.testing.assert_allclose(sc.fluence([0, 0, -3], HALF, lamp), 2 * math.pi * (1 - 6 / math.sqrt(37)), rtol=0.02)


class Edges(unittest.TestCase):
    def test_width_under_a_straight_edge(self):
        # 5 % of a disc lie beyond 0.80545 of its radius; the edge is half way to the lamp.
        width = sc.penumbra_width([[0, 0, -4], [5, 0, -4]], HALF, "disc:0,0,4 radius 0.5 facing -z", normals=(0, 0, 1))
        self.assertAlmostEqual(float(width[0]), 0.80545, delta=0.02)
        self.assertTrue(np.isnan(width[1]))

    def test_footprints_of_two_plates(self):
        ground = plate(9, 0)
        found = sc.footprints(ground, {"a": plate(1, 2), "b": ([[4, 4, 1], [5, 4, 1], [5, 5, 1], [4, 5, 1]], [[0, 1, 2, 3]])},
                              "sun: direction -z diameter 0")
        self.assertEqual(found.names, ["a", "b"])
        self.assertEqual(found.outlines.GetNumberOfLines(), 2)
        self.assertAlmostEqual(found.area(), 5.0, delta=0.05)
        self.assertAlmostEqual(found.area(umbra=True), 5.0, delta=0.05)
        self.assertRegex(repr(found), "2 outlines of 2 occluders")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "shadow.geojson")
            found.save(path)
            with open(path, encoding="utf-8") as file:
                self.assertIn('"FeatureCollection"', file.read())


class SunHours(unittest.TestCase):
    def test_day_and_night(self):
        # Equinox at the equator: half a day; midsummer beyond the polar circle: all of it; the same behind a roof: none.
        day = sc.sun_hours([[0, 0, 0]], NOTHING, 0, 0, "2024-03-20", "2024-03-21")
        self.assertEqual(day.shape, (1,))
        self.assertAlmostEqual(float(day[0]), 12.0, delta=0.15)
        june = (datetime.datetime(2024, 6, 21), datetime.datetime(2024, 6, 22), 30)
        self.assertAlmostEqual(float(sc.sun_hours([0, 0, 0], NOTHING, 80, 0, *june)), 24.0, delta=1e-3)
        self.assertLess(float(sc.sun_hours([0, 0, -1], plate(500, 0), 80, 0, *june)), 1e-3)

    def test_facade_to_the_north_and_south(self):
        # Equinox: the Sun is in the south all day. y is north.
        both = [[0, -1, 0], [0, 1, 0]]
        wall = ([[-999, 0, -999], [999, 0, -999], [999, 0, 999], [-999, 0, 999]], [[0, 1, 2, 3]])
        hours = sc.sun_hours(both, wall, 48, 0, "2024-03-20", "2024-03-21", diameter=0)
        self.assertAlmostEqual(float(hours[0]), 12.0, delta=0.4)
        self.assertLess(float(hours[1]), 0.5)

    def test_faults(self):
        with self.assertRaisesRegex(ValueError, "Latitude"):
            sc.sun_hours([0, 0, 0], NOTHING, 91, 0, "2024-03-20", "2024-03-21")
        with self.assertRaisesRegex(ValueError, "Start"):
            sc.sun_hours([0, 0, 0], NOTHING, 0, 0, "yesterday", "2024-03-21")


if __name__ == "__main__":
    unittest.main()
