#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A chair in even fog and in a fog bank on the floor: the density of the medium as an image of your own."""

import os

import common
import numpy as np
import scenes
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData


def smooth_noise(random, shape, cells):
    """Values between -1 and 1 at the points of a grid that vary over about 1 / `cells` of it."""
    noise = random.uniform(-1.0, 1.0, (cells + 1,) * 3)
    for axis, count in enumerate(shape):
        place = np.linspace(0.0, cells, count)
        cell = np.minimum(place.astype(int), cells - 1)
        share = place - cell
        share = (share * share * (3.0 - 2.0 * share)).reshape([-1 if a == axis else 1 for a in range(3)])
        noise = (1.0 - share) * noise.take(cell, axis) + share * noise.take(cell + 1, axis)
    return noise


def fog_bank(bounds, points, height, seed=1):
    """An image with `points` along each axis of the bounds: fog below a wavy height, thicker here and thinner there. The
    mean of the density is 1, so that there is as much of it as of even fog."""
    low, high = np.reshape(bounds, (3, 2)).T
    spacing = (high - low) / (points - 1)
    # VTK counts along x first: axes are z, y, x here.
    shape = (points,) * 3
    y = np.linspace(low[1], high[1], points).reshape(1, points, 1)
    random = np.random.default_rng(seed)
    noise = smooth_noise(random, shape, 4) + 0.5 * smooth_noise(random, shape, 9) + 0.25 * smooth_noise(random, shape, 19)
    density = (1.0 + 0.9 * noise.clip(-1.0, 1.0)) / (1.0 + np.exp((y - height * (1.0 + 0.6 * noise)) / (0.08 * height)))
    density[density < 1e-3] = 0.0  # rays skip what is empty above the fog
    density /= density.mean()

    image = vtkImageData()
    image.SetDimensions(points, points, points)
    image.SetOrigin(*low)
    image.SetSpacing(*spacing)
    array = numpy_to_vtk(density.astype(np.float32).ravel(), deep=True)
    array.SetName("Density")
    image.GetPointData().SetScalars(array)
    return image


def main():
    options = common.parser(__doc__, size=512, vectors=5800)
    options.add_argument("--points", type=int, default=48, help="points along each axis of the density (default: 48)")
    options.add_argument("--height", type=float, default=1.3, help="height of the fog bank (default: 1.3)")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    occluders = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))
    room = scenes.put_in_room(occluders, arguments.data)
    cones = common.cone_set(common.shadow_vectors(room, light, arguments.vectors))

    pictures = []
    for density in (None, fog_bank(scenes.MEDIUM_BOUNDS, arguments.points, arguments.height)):
        image = common.light_shafts(room, light, cones, "Medium", arguments.size)
        image.SetSigmaS(0.25)
        image.SetNumberOfSteps(80)  # the bank is dense: light fades within longer steps
        image.SetDensityData(density)
        image.SetToneCurveToFilmic()
        image.Update()
        seconds = image.GetOutput().GetFieldData().GetArray("RenderSeconds").GetTuple1(0)
        print(f"{'fog bank' if density else 'even fog'}: {seconds:.2f} s", flush=True)
        pictures.append(common.pixels(image.GetOutput()))
    common.save(common.table([pictures], ["Even fog", "Fog bank"]), os.path.join(arguments.output, "fog-bank.png"))


if __name__ == "__main__":
    main()
