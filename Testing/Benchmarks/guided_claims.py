#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What Guided claims to err by, against what it errs by, where things are as thin as a pixel, and where they are not:
guided_claims.py [--scene NAME ...]

Error over claim against an image of another seed with 8,192 samples a pixel: of all pixels, and of those in shadow alone, since
pixels that no shadow reaches err by nothing. Honest claims have an rms of 1 or less, and 95 % of the pixels or more within two.
"""

import argparse
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkTriangleFilter, vtkTubeFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCylinderSource
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkRenderingCore import vtkCamera

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
import scenes  # noqa: E402
import shadowcones as sc  # noqa: E402


def globe(place, radius, fine):
    sphere = scenes.ball(place, radius, fine)
    sphere.Update()
    return sphere.GetOutput()


def rods(random):
    """Thirty thin ones, every way round."""
    for _ in range(30):
        rod = vtkCylinderSource()
        rod.SetRadius(0.01)
        rod.SetHeight(1.5)
        rod.SetResolution(24)
        place = vtkTransform()
        place.Translate(*random.uniform((-1.5, 1.5, -1.5), (1.5, 3.5, 1.5)))
        place.RotateWXYZ(random.uniform(0.0, 360.0), *random.normal(size=3))
        stand = vtkTransformPolyDataFilter()
        stand.SetInputConnection(rod.GetOutputPort())
        stand.SetTransform(place)
        stand.Update()
        stand.GetOutput().GetPointData().Initialize()
        yield stand.GetOutput()


def leaves(random):
    """A hundred and fifty, a few pixels wide."""
    for _ in range(150):
        first, second = random.normal(size=(2, 3))
        first /= np.linalg.norm(first)
        second = np.cross(first, second)
        second /= np.linalg.norm(second)
        yield scenes.sheet(random.uniform((-1.5, 2.5, -1.5), (1.5, 3.5, 1.5)), 0.12 * first, 0.12 * second, (1, 1))


def slats(random):
    for row in range(30):
        yield scenes.solid(-1.5, 1.5, 3.0, 3.02, -1.5 + 0.1 * row, -1.45 + 0.1 * row)


def dots(random):
    """Balls of half a pixel."""
    for x in np.linspace(-1.4, 1.4, 12):
        for z in np.linspace(-1.4, 1.4, 12):
            yield globe((x, 3.2, z), 0.015, 20)


def balls(random):
    for _ in range(15):
        yield globe(random.uniform((-1.5, 0.5, -1.5), (1.5, 3.5, 1.5)), random.uniform(0.1, 0.35), 120)


def knot(random):
    """A tube around a torus, three times one way and twice the other."""
    turn = np.linspace(0.0, 2.0 * np.pi, 401)[:-1]
    radius = 1.0 + 0.4 * np.cos(3.0 * turn)
    path = np.column_stack((radius * np.cos(2.0 * turn), 2.5 + radius * np.sin(2.0 * turn), 0.4 * np.sin(3.0 * turn)))
    points = vtkPoints()
    for place in path:
        points.InsertNextPoint(place)
    lines = vtkCellArray()
    lines.InsertNextCell(len(path) + 1)
    for k in range(len(path) + 1):
        lines.InsertCellPoint(k % len(path))
    line = vtkPolyData()
    line.SetPoints(points)
    line.SetLines(lines)
    tube = vtkTubeFilter()
    tube.SetInputData(line)
    tube.SetRadius(0.16)
    tube.SetNumberOfSides(24)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(tube.GetOutputPort())
    triangles.Update()
    triangles.GetOutput().GetPointData().Initialize()
    yield triangles.GetOutput()


def shards(random):
    """Sixty triangles of any size."""
    for _ in range(60):
        first, second = random.normal(size=(2, 3))
        size = random.uniform(0.05, 0.5)
        yield scenes.sheet(random.uniform((-1.5, 0.5, -1.5), (1.5, 3.5, 1.5)), size * first, size * second, (1, 1))


def fence(random):
    """Thirteen pickets in front of a ball."""
    yield globe((0.0, 1.6, -0.4), 0.9, 120)
    for k in range(13):
        yield scenes.solid(-1.6 + 0.25 * k, -1.48 + 0.25 * k, 0.0, 2.4, 1.0, 1.04)


def sphere(random):
    yield globe((0.0, 2.5, 0.0), 1.0, 400)


def bunny(random):
    reader = vtkOBJReader()
    reader.SetFileName(BUNNY)
    reader.Update()
    bounds = reader.GetOutput().GetBounds()
    scale = 3.0 / (bounds[3] - bounds[2])
    place = vtkTransform()
    place.Scale(scale, scale, scale)
    place.Translate(-0.5 * (bounds[0] + bounds[1]), -bounds[2], -0.5 * (bounds[4] + bounds[5]))
    stand = vtkTransformPolyDataFilter()
    stand.SetInputConnection(reader.GetOutputPort())
    stand.SetTransform(place)
    stand.Update()
    stand.GetOutput().GetPointData().Initialize()
    yield stand.GetOutput()


def data(name):
    return lambda random: iter([scenes.read(os.path.join(scenes.DATA, name + ".vtp"))])


def lamp(light_of):
    light = sc.vtkAreaLightSource()
    light_of(light)
    return light


def small_sphere(light):
    light.SetShapeToSphere()
    light.SetCenter(1.2, 4.6, 0.8)
    light.SetRadius(0.3)


def sun(light):
    light.SetShapeToSun()
    light.SetNormal(0.5, -1.0, -0.3)
    light.SetAngularDiameter(2.0)


THIN = {make.__name__: make for make in (rods, leaves, slats, dots, balls)}
OTHERS = {make.__name__: make for make in (bunny, sphere, knot, shards, fence)}
OTHERS.update({name: data(name) for name in ("chair", "tree", "blob")})
SCENES = {**THIN, **OTHERS}
LIGHTS = {"knot": small_sphere, "shards": sun}  # of the others the disc of the examples
BUNNY = "/usr/share/glmark2/models/bunny.obj"


def parts_of(options):
    """Squares of an image, spread evenly over it: the extents that are judged. An extent has the bytes of the whole image."""
    most = options.size - options.part
    for k in range(options.parts if options.part else 0):
        first = [int((0.5 + step * (k + 1)) % 1.0 * most) for step in (0.7548776662466927, 0.5698402909980532)]
        yield (first[0], first[0] + options.part - 1, first[1], first[1] + options.part - 1, 0, 0)


def put_ink(image, depth):
    """Points of any density, 16 a side, whose cells are so deep in the mean: the hardest that a polynomial can be asked to follow."""
    low, high = np.array(scenes.MEDIUM_BOUNDS).reshape(3, 2).T
    spacing = (high - low) / 15.0
    ink = vtkImageData()
    ink.SetDimensions(16, 16, 16)
    ink.SetOrigin(*low)
    ink.SetSpacing(*spacing)
    density = numpy_to_vtk(np.random.default_rng(7).uniform(0.0, 2.0, 16**3), deep=1)
    density.SetName("Density")
    ink.GetPointData().AddArray(density)
    image.SetDensityData(ink)
    image.SetSigmaS(0.5 * depth / spacing.mean())
    image.SetSigmaA(0.5 * depth / spacing.mean())


def image_of(mesh, light, options, seed, goal, samples):
    """Values, relative errors that are claimed, samples a pixel, and seconds of the processor."""
    camera = vtkCamera()
    camera.SetPosition(0.0, 2.4, 9.5)
    camera.SetFocalPoint(0.0, 2.4, 0.0)
    camera.SetViewAngle(36.0)
    image = sc.vtkScatteringImageFilter()
    image.SetInputConnection(mesh.GetOutputPort())
    image.SetLightConnection(light.GetOutputPort())
    image.SetCamera(camera)
    image.SetResolution(options.size, options.size)
    image.SetMediumBounds(*scenes.MEDIUM_BOUNDS)
    image.SetRelativeErrorGoal(goal)
    image.SetMaximumSamples(samples)
    image.SetNumberOfSurfaceLightSamples(0)
    image.LightVisibleOff()
    image.SetSeed(seed)
    image.AutoExposureOff()
    if options.depth > 0.0:
        put_ink(image, options.depth)
    if options.depth > 0.0 and goal == 0.0:
        # No polynomials through the ink, as Guided has them.
        image.SetModeToBruteForce()
        image.SetNumberOfSteps(4000)
        image.SetNumberOfLightSamples(256)
    start = time.process_time()
    found = []
    for extent in parts_of(options) if options.part else [None]:
        image.UpdateExtent(extent) if extent else image.Update()
        points = image.GetOutput().GetPointData()
        value = vtk_to_numpy(points.GetArray("InScattering")).astype(float)
        arrays = [value.reshape(points.GetNumberOfTuples(), -1).mean(axis=1)]
        for name in ("RelativeError", "SampleCount"):
            array = points.GetArray(name)
            arrays.append(vtk_to_numpy(array).astype(float) if array else np.zeros(len(arrays[0])))
        found.append(arrays)
    return (*(np.concatenate(each) for each in zip(*found)), time.process_time() - start)


def receivers(mesh):
    """The same, which hides no light."""
    ids = vtkIntArray()
    ids.SetName("OccluderId")
    ids.SetNumberOfTuples(mesh.GetNumberOfCells())
    ids.Fill(-1)
    producer = vtkTrivialProducer()
    copy = vtkPolyData()
    copy.ShallowCopy(mesh)
    copy.GetCellData().AddArray(ids)
    producer.SetOutput(copy)
    return producer


def judged(ratio):
    return f"{np.sqrt((ratio**2).mean()):9.2f} {ratio.mean():+6.2f} {100.0 * (abs(ratio) < 2.0).mean():7.1f} % {abs(ratio).max():5.1f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scene", nargs="+", choices=SCENES, default=list(THIN), help="(default: those as thin as a pixel)")
    parser.add_argument("--size", type=int, default=96, help="of the image in pixels (default: 96)")
    parser.add_argument("--part", type=int, default=0, help="judge squares of so many pixels a side alone (default: the image)")
    parser.add_argument("--parts", type=int, default=8, help="so many of them (default: 8)")
    parser.add_argument("--depth", type=float, default=0.0,
                        help="in rough ink whose cells have this optical depth, against BruteForce: a second a pixel (default: even fog)")
    parser.add_argument("--goal", type=float, nargs="+", default=[0.01], help="RelativeErrorGoal (default: 0.01)")
    options = parser.parse_args()
    print("                                         error/claim of all              in shadow")
    print("scene    goal  samples seconds rms error   rms   mean  within 2  worst   share   rms   mean  within 2  worst")
    for name in options.scene:
        # Finely cut, so that samples are cheaper than lines.
        random = np.random.default_rng(5)
        mesh = scenes.joined([*SCENES[name](random), globe((1.6, 0.4, -1.0), 0.3, 900)])
        light = lamp(LIGHTS[name]) if name in LIGHTS else scenes.ceiling_light()
        occluders = scenes.label(mesh)
        truth, noise, _, _ = image_of(occluders, light, options, 99, 0.0, 8192)
        lit = image_of(receivers(mesh), light, options, 99, 0.0, 1)[0]
        for goal in options.goal:
            value, claim, samples, seconds = image_of(occluders, light, options, 1, goal, 1024)
            seen = (truth > 0.0) & (value > 0.0)
            shadow = (truth < 0.999 * lit)[seen]
            ratio = (value - truth)[seen] / np.hypot(claim * value, noise * truth)[seen]
            error = np.sqrt(((value - truth)[seen] ** 2).mean()) / truth[seen].mean()
            print(f"{name:7} {goal:5g} {samples.mean():8.1f} {seconds:7.2f} {error:9.5f}{judged(ratio)}"
                  f" {100.0 * shadow.mean():5.1f} %{judged(ratio[shadow])}", flush=True)


if __name__ == "__main__":
    main()
