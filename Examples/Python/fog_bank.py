#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A chair in even fog and in a fog bank on the floor: the density of the medium as an image of your own."""

import common
import numpy as np
import scenes
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData


def fog_bank(bounds, points, height, seed=1):
    """An image with `points` along each axis of the bounds: fog below a wavy height, thicker here and thinner there.
    The mean of the density is 1, so that there is as much of it as of even fog."""
    low, high = np.reshape(bounds, (3, 2)).T
    y = np.linspace(low[1], high[1], points).reshape(1, points, 1)  # VTK counts along x first: axes are z, y, x
    random = np.random.default_rng(seed)
    noise = sum(share * scenes.smooth_noise(random, points, cells) for share, cells in ((1.0, 4), (0.5, 9), (0.25, 19)))
    density = (1.0 + 0.9 * noise.clip(-1.0, 1.0)) / (1.0 + np.exp((y - height * (1.0 + 0.6 * noise)) / (0.08 * height)))
    density[density < 1e-3] = 0.0  # rays skip what is empty above the fog
    image = vtkImageData()
    image.SetDimensions(points, points, points)
    image.SetOrigin(*low)
    image.SetSpacing(*((high - low) / (points - 1)))
    image.GetPointData().SetScalars(numpy_to_vtk((density / density.mean()).astype(np.float32).ravel(), deep=True))
    image.GetPointData().GetScalars().SetName("Density")
    return image


def chair_in_fog(room, light, cones, density, size):
    """The picture, with a density or, without one, in even fog."""
    image = common.light_shafts(room, light, cones, "Medium", size)
    image.SetSigmaS(0.25)
    image.SetNumberOfSteps(80)  # the bank is dense: light fades within longer steps
    image.SetDensityData(density)
    image.SetToneCurveToFilmic()
    image.Update()
    seconds = common.array(image.GetOutput().GetFieldData(), "RenderSeconds")[0]
    print(f"{'fog bank' if density else 'even fog'}: {seconds:.2f} s", flush=True)
    return common.pixels(image.GetOutput())


def main():
    options = common.parser(__doc__, size=512, vectors=5800)
    options.add_argument("--points", type=int, default=48, help="points along each axis of the density (default: 48)")
    options.add_argument("--height", type=float, default=1.3, help="height of the fog bank (default: 1.3)")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    occluders = scenes.label(scenes.read(f"{arguments.data}/chair.vtp"))
    room = scenes.put_in_room(occluders, arguments.data)
    cones = common.cone_set(common.shadow_vectors(room, light, arguments.vectors))
    bank = fog_bank(scenes.MEDIUM_BOUNDS, arguments.points, arguments.height)
    pictures = [chair_in_fog(room, light, cones, density, arguments.size) for density in (None, bank)]
    common.save(common.table([pictures], ["Even fog", "Fog bank"]), f"{arguments.output}/fog-bank.png")


if __name__ == "__main__":
    main()
