#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What Guided claims to err by, against what it errs by, where things are as thin as a pixel: guided_claims.py [--scene NAME ...]

Error over claim of all pixels against an image of another seed with 8,192 samples a pixel. Honest claims have an rms of 1 or less, and
95 % of the pixels or more within two.
"""

import argparse
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCylinderSource
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


SCENES = {make.__name__: make for make in (rods, leaves, slats, dots, balls)}


def image_of(mesh, options, seed, goal, samples):
    """Values, relative errors that are claimed, samples a pixel, and seconds of the processor."""
    light = scenes.ceiling_light()
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
    start = time.process_time()
    image.Update()
    seconds = time.process_time() - start
    points = image.GetOutput().GetPointData()
    arrays = [vtk_to_numpy(points.GetArray(name)).astype(float) for name in ("InScattering", "RelativeError", "SampleCount")]
    arrays[0] = arrays[0].reshape(len(arrays[1]), -1).mean(axis=1)
    return (*arrays, seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scene", nargs="+", choices=SCENES, default=list(SCENES), help="(default: all)")
    parser.add_argument("--size", type=int, default=96, help="of the image in pixels (default: 96)")
    parser.add_argument("--goal", type=float, default=0.01, help="RelativeErrorGoal (default: 0.01)")
    options = parser.parse_args()
    print("scene   samples  seconds  error/claim: rms   mean  within 2   worst  rms error")
    for name in options.scene:
        # Finely cut, so that samples are cheaper than lines.
        random = np.random.default_rng(5)
        occluders = scenes.label(scenes.joined([*SCENES[name](random), globe((1.6, 0.4, -1.0), 0.3, 900)]))
        truth, noise, _, _ = image_of(occluders, options, 99, 0.0, 8192)
        value, claim, samples, seconds = image_of(occluders, options, 1, options.goal, 1024)
        seen = (truth > 0.0) & (value > 0.0)
        ratio = ((value - truth) / np.hypot(claim * value, noise * truth))[seen]
        print(f"{name:7} {samples.mean():7.1f} {seconds:8.2f} {np.sqrt((ratio**2).mean()):17.2f} {ratio.mean():+6.2f} "
              f"{100.0 * (abs(ratio) < 2.0).mean():8.1f} % {abs(ratio).max():6.1f} "
              f"{np.sqrt((((value - truth) / truth)[seen] ** 2).mean()):10.4f}", flush=True)


if __name__ == "__main__":
    main()
