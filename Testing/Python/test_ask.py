#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Questions in one line: right values by hand, whatever comes as a mesh and a light, faults as exceptions, files, Ctrl-C."""

import gc
import io
import math
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings

import numpy as np
import shadowcones as sc
from shadowcones import _meshes, _run
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkMassProperties
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkCamera

DATA = os.environ.get("SHADOWCONES_DATA_DIR", os.path.join(os.path.dirname(__file__), "..", "..", "Data"))

# All of x < 0 at height 0.
HALF = ([[-100, -100, 0], [0, -100, 0], [0, 100, 0], [-100, 100, 0]], [[0, 1, 2, 3]])
PLATE = ([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]])


class Mesh(vtkPolyData):
    """What PyVista makes of a mesh: a Python class above VTK's, with things of its own."""

    @property
    def points(self):
        return vtk_to_numpy(self.GetPoints().GetData())


def ball(center=(0.0, 0.0, 0.0), kind=vtkPolyData):
    source = vtkSphereSource()
    source.SetCenter(*center)
    source.Update()
    mesh = kind()
    mesh.ShallowCopy(source.GetOutput())
    return mesh


class Values(unittest.TestCase):
    def test_visibility_under_a_straight_edge(self):
        # From (x, 0, -4) the edge covers x' < -x of the disc at height 4: a segment of the circle.
        x = np.linspace(-1.2, 1.2, 25)
        points = np.stack([x, 0 * x, 0 * x - 4], axis=1)
        seen = sc.visibility(points, HALF, "disc:0,0,4 radius 1 facing -z", samples=4096)
        h = np.clip(x, -1, 1)
        right = 1 - (np.arccos(h) - h * np.sqrt(1 - h * h)) / math.pi
        self.assertEqual(seen.dtype, np.float32)
        np.testing.assert_allclose(seen, right, atol=2e-3)

    def test_several_lights_have_a_column_each(self):
        seen = sc.visibility([[-1, 0, -1], [1, 0, -1]], HALF, ["point:0,0,4", "point:-50,0,4"])
        np.testing.assert_array_equal(seen, [[0, 0], [1, 0]])  # from -50 the ray to x = 1 passes the height 0 at x < 0
        np.testing.assert_array_equal(sc.visibility([[1, 0, -1]], HALF, "point:0,0,4; point:50,0,4"), [[1, 1]])

    def test_one_point(self):
        self.assertEqual(sc.visibility([0, 0, -1], PLATE, "point:0,0,4"), 0)
        self.assertEqual(np.shape(sc.visibility((0, 0, -1), PLATE, "point:0,0,4")), ())

    def test_data_sets_come_back_with_arrays(self):
        plane = vtkPlaneSource()
        plane.SetResolution(4, 4)
        plane.Update()
        for cells in (False, True):
            answer = sc.visibility(plane.GetOutput(), {"ball": ball((0, 0, 2))}, "sun: direction -z diameter 0", cells=cells)
            self.assertIsInstance(answer, vtkPolyData)
            attributes = answer.GetCellData() if cells else answer.GetPointData()
            self.assertEqual(attributes.GetArray("Visibility").GetNumberOfTuples(), 16 if cells else 25)
            self.assertIsNone(plane.GetOutput().GetPointData().GetArray("Visibility"))
        self.assertEqual(sc.visibility(plane, PLATE, "point:0,0,9").GetNumberOfPoints(), 25)  # a filter has a data set
        grid = vtkImageData()
        grid.SetDimensions(3, 3, 3)
        grid.SetOrigin(-1, -1, -1)
        self.assertIsInstance(sc.visibility(grid, PLATE, "point:0,0,9"), vtkImageData)

    def test_whose_shadow(self):
        below = [[0, 0, -2], [5, 0, -2], [9, 0, -2]]
        balls = {"left": ball(), "right": ball((5, 0, 0))}
        sun = "sun: direction -z diameter 0"
        self.assertEqual(sc.shadow_of(below, balls, sun).tolist(), ["left", "right", ""])
        self.assertEqual(sc.shadow_of([0, 0, -2], balls, sun), "left")
        # Without names: numbers, one a component.
        numbers = sc.shadow_of(below, list(balls.values()), sun)
        self.assertEqual(numbers.dtype, np.int64)
        self.assertEqual(numbers.tolist(), [0, 1, -1])
        two = sc.shadow_of(below, balls, [sun, sun])
        self.assertEqual(two.shape, (3, 2))

    def test_shafts_of_a_slab(self):
        # Light straight down, a ray straight through at depth 0.5: sigma E / (4 pi) e^(-sigma d) (1 - e^(-sigma s)) / sigma.
        sigma, camera = 0.7, vtkCamera()
        camera.SetPosition(0, 0.5, 10)
        camera.SetFocalPoint(0, 0.5, 0)
        camera.SetViewAngle(1)
        shot = sc.light_shafts(ball((50, 0, 0)), "sun: direction -y", camera, (3, 3), 0.001,
                               medium=(-0.5, 0.5, 0, 1, -0.5, 0.5), sigma_s=sigma)
        right = math.exp(-0.5 * sigma) * (1 - math.exp(-sigma)) / (4 * math.pi)
        self.assertEqual(shot.radiance.shape, (3, 3, 7))
        np.testing.assert_allclose(shot.radiance[1, 1], right, rtol=2e-3)

    def test_row_0_is_the_top(self):
        shot = sc.light_shafts(ball((50, 0, 0)), "disc:0,1,0 radius 0.2 facing -y", ((0, 0, 6), (0, 0, 0), (0, 1, 0)), (20, 20),
                               medium=(-1, 1, -1, 1, -1, 1))
        self.assertGreater(shot.radiance[:10].sum(), 2 * shot.radiance[10:].sum())
        self.assertEqual(shot.rgb.dtype, np.uint8)
        self.assertEqual(shot.rgb.shape, (20, 20, 3))
        self.assertTrue(np.shares_memory(shot.rgb, vtk_to_numpy(shot.image.GetPointData().GetArray("RGB"))))

    def test_defaults_give_a_picture(self):
        for mesh in ("chair.vtp", "cornell-box.vtp"):
            shot = sc.light_shafts(os.path.join(DATA, mesh), size=(32, 24), error=0.2)
            grey = shot.rgb.mean(axis=2)
            self.assertGreater((grey > 20).mean(), 0.3, mesh)
            self.assertLess((grey > 250).mean(), 0.2, mesh)

    def test_up_turns_a_sun_in_words(self):
        shot = sc.light_shafts(PLATE, "sun: azimuth 0 altitude 90", size=(4, 4), up="y")
        np.testing.assert_allclose(shot.lights[0].GetNormal(), (0, -1, 0), atol=1e-15)
        np.testing.assert_allclose(shot.camera.GetViewUp(), (0, 1, 0))

    def test_cones_hold_the_shadow_and_say_so(self):
        found = sc.cones(ball(), "disc:0,0,3 radius 0.2 facing -z", vectors=500)
        self.assertEqual(found.GetFieldData().GetArray("Certified").GetValue(0), 1)
        self.assertGreater(found.GetNumberOfPoints(), 0)

    def test_solids_bound_the_shadow_of_a_plate(self):
        # Under a hard sun: a box of 2 x 2 x 1.
        solids = sc.shadow_solids(PLATE, "sun: direction -z diameter 0", bounds=(-3, 3, -3, 3, -1, 0.5), resolution=48)
        measure = vtkMassProperties()
        measure.SetInputData(solids.outer)
        self.assertAlmostEqual(measure.GetVolume(), 4.0, delta=0.04)
        self.assertRegex(repr(solids), r"outer \d+ triangles, inner \d+")


class Inputs(unittest.TestCase):
    LIGHT = "point:0,0,4"

    def blocked(self, mesh):
        return sc.visibility([[0, 0, -2], [9, 9, -2]], mesh, self.LIGHT).tolist()

    def test_everything_that_is_a_mesh(self):
        points, faces = (np.array(part) for part in PLATE)
        packed = np.insert(faces, 0, 3, axis=1).ravel()
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "ball.stl")
            writer = vtkSTLWriter()
            writer.SetInputData(ball())
            writer.SetFileName(str(path))
            writer.Write()

            class Other:
                vertices, faces = PLATE

            source = vtkSphereSource()
            for mesh in (ball(), ball(kind=Mesh), PLATE, (points, faces), (points.astype(np.float32), faces), (points, packed),
                         (points, [[0, 1, 2, 3]]), ([*PLATE[0], [0, 0, 1]], [[0, 1, 2, 3], [0, 1, 4]]), Other(), source, path,
                         str(path), [ball(), ball((3, 0, 0))], [path, PLATE], {"a": path}, (ball(), ball())):
                with self.subTest(type(mesh).__name__):
                    self.assertEqual(self.blocked(mesh), [0.0, 1.0])

    def test_surfaces_of_volumes(self):
        block = vtkImageData()
        block.SetDimensions(3, 3, 3)
        block.SetOrigin(-1, -1, -1)
        self.assertEqual(self.blocked(block), [0.0, 1.0])

    def test_points_are_not_copied(self):
        for kind in (np.float32, np.float64):
            array = np.zeros((5, 3), dtype=kind)
            points = _meshes.points_of(array)
            gc.collect()
            self.assertTrue(np.shares_memory(array, vtk_to_numpy(points.GetData())))

    def test_faces_outlive_their_arrays(self):
        mesh = _meshes.polydata_of(np.random.rand(100, 3), np.arange(99).reshape(33, 3))
        copy = vtkPolyData()
        copy.ShallowCopy(mesh)
        del mesh
        gc.collect()
        np.random.rand(10000)
        self.assertEqual(copy.GetCell(32).GetPointId(2), 98)

    def test_everything_that_is_a_light(self):
        point = sc.vtkAreaLightSource()
        point.SetShapeToPoint()
        point.SetCenter(0, 0, 4)
        point.Update()
        lamp = vtkPlaneSource()  # shines up: turned by its points
        lamp.SetOrigin(-0.1, -0.1, 4)
        lamp.SetPoint1(-0.1, 0.1, 4)
        lamp.SetPoint2(0.1, -0.1, 4)
        for light in ("point:0,0,4", point, point.GetOutput(), lamp, [point], ([[-.1, -.1, 4], [-.1, .1, 4], [.1, 0, 4]], [[0, 1, 2]])):
            with self.subTest(type(light).__name__):
                self.assertEqual(np.ravel(sc.visibility([[0, 0, -2], [9, 9, -2]], PLATE, light)).tolist(), [0.0, 1.0])

    def test_ids_of_the_mesh_are_names(self):
        mesh = ball()
        ids = np.full(mesh.GetNumberOfCells(), 70, dtype=np.int64)
        array = _meshes.numpy_to_vtk(ids, deep=True)
        array.SetName("OccluderId")
        mesh.GetCellData().AddArray(array)
        self.assertEqual(sc.shadow_of([[0, 0, -2], [9, 9, -2]], mesh, self.LIGHT).tolist(), ["70", ""])

    def test_bad_input(self):
        light = self.LIGHT
        ask = sc.visibility
        where = [[0, 0, -2]]

        def bad_lamp():
            lamp = sc.vtkAreaLightSource()
            lamp.SetRadius(-1)
            return lamp

        cases = [
            (TypeError, "a mesh must be a path", lambda: ask(where, 5, light)),
            (TypeError, "a mesh must be a path", lambda: ask(where, None, light)),
            (FileNotFoundError, 'There is no file "none.stl"', lambda: ask(where, "none.stl", light)),
            (ValueError, "is of no format that is read", lambda: ask(where, __file__, light)),
            (ValueError, "the list of meshes is empty", lambda: ask(where, [], light)),
            (ValueError, "face 0 uses point 7, of 4 points", lambda: ask(where, (PLATE[0], [[0, 1, 7]]), light)),
            (ValueError, "face 0 uses point -1", lambda: ask(where, (PLATE[0], [[0, 1, -1]]), light)),
            (ValueError, "face 1 has 2 corners", lambda: ask(where, (PLATE[0], [[0, 1, 2], [0, 1]]), light)),
            (ValueError, "faces must be whole numbers", lambda: ask(where, (PLATE[0], [[0.5, 1, 2]]), light)),
            (ValueError, "packed faces end inside", lambda: ask(where, (PLATE[0], [3, 0, 1]), light)),
            (ValueError, "points must be an (n, 3) array", lambda: ask(where, ([[0, 1]], [[0, 0, 0]]), light)),
            (ValueError, "points must be numbers", lambda: ask(where, ([["a", "b", "c"]], [[0, 0, 0]]), light)),
            (ValueError, "where must be an (n, 3) array", lambda: ask([[0, 0]], PLATE, light)),
            (ValueError, "not finite", lambda: ask(where, ([[0, 0, math.nan], *PLATE[0][1:]], PLATE[1]), light)),
            (TypeError, "a light is needed: words such as", lambda: ask(where, PLATE, None)),
            (ValueError, 'column 7: expected three numbers', lambda: ask(where, PLATE, "point:zero")),
            (ValueError, "the list of lights is empty", lambda: ask(where, PLATE, [])),
            (ValueError, "NumberOfLightSamples is 0: it must be in 1..65536", lambda: ask(where, PLATE, light, samples=0)),
            (TypeError, "progress must be True or something to call", lambda: ask(where, PLATE, light, progress=3)),
            (ValueError, "both must be at least 1", lambda: sc.light_shafts(PLATE, size=(0, 5))),
            (TypeError, "size must be (width, height)", lambda: sc.light_shafts(PLATE, size=5)),
            (TypeError, "camera must be a vtkCamera or", lambda: sc.light_shafts(PLATE, camera=(1, 2, 3), size=(4, 4))),
            (ValueError, "tone must be", lambda: sc.light_shafts(PLATE, tone="soft", size=(4, 4))),
            (ValueError, "up must be x, y or z", lambda: sc.light_shafts(PLATE, up="w", size=(4, 4))),
            (ValueError, "error is 0", lambda: sc.light_shafts(PLATE, error=0, size=(4, 4))),
            (ValueError, "vtkAreaLightSource: ", lambda: sc.light_shafts(PLATE, bad_lamp(), size=(4, 4))),
            (ValueError, "vtkAreaLightSource: ", lambda: ask(where, PLATE, bad_lamp())),
            (ValueError, "SigmaS", lambda: sc.light_shafts(PLATE, sigma_s=-1, size=(4, 4))),
            (ValueError, 'which must be "outer" or "inner"', lambda: sc.Solids(None, None).save("a.stl", "both")),
        ]
        for kind, said, call in cases:
            with self.subTest(said), self.assertRaises(kind) as caught:
                call()
            self.assertIn(said, str(caught.exception))

    def test_warnings_name_the_callers_line(self):
        far = [[x, 0, 90] for x in range(20)]
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            sc.cones(([[-5, -5, 9], [5, -5, 9], [0, 5, 9]], [[0, 1, 2]]), "disc:0,0,5 radius 1 facing -z", vectors=100)
        self.assertTrue(far and said)
        self.assertEqual(os.path.basename(said[0].filename), os.path.basename(__file__))
        self.assertIn("vtk", str(said[0].message))


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.shot = sc.light_shafts(PLATE, "disc:0,0,3 radius 0.3 facing -z", size=(8, 6), error=0.5)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_pictures(self):
        for name in ("a.png", "a.tif", "a.jpg", "a.bmp", "a.vti", "a.npy"):
            self.shot.save(self.path(name))
            self.assertGreater(os.path.getsize(self.path(name)), 50)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["a.bmp", "a.jpg", "a.npy", "a.png", "a.tif", "a.vti"])
        reader = vtkPNGReader()
        reader.SetFileName(self.path("a.png"))
        reader.Update()
        read = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(6, 8, 3)
        np.testing.assert_array_equal(read[::-1], self.shot.rgb)
        np.testing.assert_array_equal(np.load(self.path("a.npy")), self.shot.radiance)
        self.assertTrue(self.shot._repr_png_().startswith(b"\x89PNG"))
        self.assertRegex(repr(self.shot), r"<shadowcones.Shot 8 x 6, 7 wavelengths, \d+\.\d\d s>")

    def test_faults(self):
        with self.assertRaisesRegex(ValueError, "must end in one of .bmp"):
            self.shot.save(self.path("a.gif"))
        with self.assertRaises(OSError):
            self.shot.save(self.path("none/a.png"))
        with self.assertRaises(KeyError):
            self.shot.array("None")
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_solids(self):
        solids = sc.shadow_solids(ball(), "point:0,0,3", resolution=16)
        solids.save(self.path("solid.stl"))
        reader = vtkSTLReader()
        reader.SetFileName(self.path("solid.stl"))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfPolys(), solids.outer.GetNumberOfPolys())


class Progress(unittest.TestCase):
    def test_fractions_rise_to_1(self):
        told = []
        sc.light_shafts(os.path.join(DATA, "chair.vtp"), size=(48, 48), error=0.05, progress=told.append)
        self.assertGreater(len(told), 5)
        self.assertEqual(told, sorted(told))
        self.assertEqual(told[-1], 1.0)

    def test_lines(self):
        stream = io.StringIO()
        lines = _run.Lines(stream)
        for fraction in (0.0, 0.05, 0.5, 0.51, 1.0):
            lines(fraction)
        self.assertEqual(stream.getvalue(), "  0 %\n 50 %\n100 %\n")

    def test_what_the_listener_raises_comes_through(self):
        def stop(fraction):
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            sc.light_shafts(os.path.join(DATA, "chair.vtp"), size=(48, 48), progress=stop)


class Interrupt(unittest.TestCase):
    def test_ctrl_c_stops_soon_and_the_handler_comes_back(self):
        before = signal.getsignal(signal.SIGINT)
        # From outside: threads of this process wait while VTK works.
        begin = time.monotonic()
        killer = subprocess.Popen(["sh", "-c", f"sleep 0.7; kill -INT {os.getpid()}"])
        with self.assertRaises(KeyboardInterrupt):
            # A minute of work.
            sc.light_shafts(os.path.join(DATA, "tree.vtp"), size=(900, 900), error=0.001)
        self.assertLess(time.monotonic() - begin, 0.7 + 3.0)  # the machine may have more to do than this
        self.assertEqual(killer.wait(), 0)
        self.assertIs(signal.getsignal(signal.SIGINT), before)
        # The same filters answer again.
        self.assertEqual(sc.visibility([[0, 0, -1]], PLATE, "point:0,0,4").tolist(), [0.0])

    def test_other_threads_may_ask(self):
        answers = []
        thread = threading.Thread(target=lambda: answers.append(sc.visibility([[0, 0, -1]], PLATE, "point:0,0,4").tolist()))
        thread.start()
        thread.join()
        self.assertEqual(answers, [[0.0]])


class Package(unittest.TestCase):
    def test_names_are_clean(self):
        self.assertEqual(sorted(dir(sc)), sorted(sc.__all__))
        for name in dir(sc):
            self.assertTrue(hasattr(sc, name), name)
            self.assertNotIn("_", name.strip("_") if name.startswith("vtk") else "")
        self.assertEqual([name for name in dir(sc) if name.startswith("_")], ["__version__"])

    def test_every_question_has_its_help(self):
        for name in dir(sc):
            if name[0].islower() and not name.startswith("vtk"):
                text = getattr(sc, name).__doc__
                for part in ("Args:", "Returns:", "Raises:", "Example:", ">>> "):
                    self.assertIn(part, text, name)

    def test_stubs_name_what_is_there(self):
        folder = os.path.dirname(sc.__file__)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))
        with open(os.path.join(folder, "__init__.pyi"), encoding="utf-8") as stubs:
            text = stubs.read()
        for name in sc.__all__:
            self.assertRegex(text, rf"(?m)^(def|class) {name}\b|^{name}:", name)


if __name__ == "__main__":
    unittest.main()
