#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How much of the sky a street sees: a sky of 145 patches, each a light of its own. Needs a display."""

import os

import common
import numpy as np
import shadowcones as sc
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkRenderer

# Patches in rings of 12 degrees from the horizon up, as sky scanners take them (P. R. Tregenza, 1987).
RINGS = (30, 30, 24, 24, 18, 12, 6, 1)
WIDTH, HEIGHT, LENGTH = 12.0, 9.0, 400.0  # of the street between its houses, metres
MOST = 0.6  # the end of the scale of colours


def patches():
    """Directions towards the patches, a row each, and their solid angles."""
    directions, angles = [], []
    for ring, count in enumerate(RINGS):
        low = np.radians(12.0 * ring)
        high = min(np.radians(12.0 * (ring + 1)), 0.5 * np.pi)
        middle = 0.5 * np.pi if count == 1 else np.arcsin(0.5 * (np.sin(low) + np.sin(high)))
        for azimuth in 2.0 * np.pi * (np.arange(count) + 0.5) / count:
            directions.append((np.cos(middle) * np.sin(azimuth), np.cos(middle) * np.cos(azimuth), np.sin(middle)))
            angles.append(2.0 * np.pi * (np.sin(high) - np.sin(low)) / count)
    return np.array(directions), np.array(angles)


def sky(directions, angles):
    """Each patch as a Sun of its size."""
    lights = []
    for direction, angle in zip(directions, angles):
        light = sc.vtkAreaLightSource()
        light.SetShapeToSun()
        light.SetNormal(*-direction)
        light.SetAngularDiameter(2.0 * np.degrees(np.arccos(1.0 - angle / (2.0 * np.pi))))
        lights.append(light)
    return lights


def street():
    """Two long rows of houses along y."""
    blocks = vtkMultiBlockDataSet()
    for number, side in enumerate((-1.0, 1.0)):
        row = vtkCubeSource()
        inner, outer = side * 0.5 * WIDTH, side * (0.5 * WIDTH + 8.0)
        row.SetBounds(min(inner, outer), max(inner, outer), -0.5 * LENGTH, 0.5 * LENGTH, 0.0, HEIGHT)
        row.Update()
        blocks.SetBlock(number, row.GetOutput())
    occluders = sc.vtkLabelOccluders()
    occluders.SetInputData(blocks)
    return occluders


def sky_view(where, occluders, samples):
    """The share of the sky's light on level ground that arrives: a value a cell."""
    directions, angles = patches()
    probe = sc.vtkConeSetProbe()
    probe.SetInputConnection(where.GetOutputPort())
    probe.SetMeshConnection(occluders.GetOutputPort())
    probe.SetAssociationToCells()
    probe.SetNumberOfLightSamples(samples)
    lights = sky(directions, angles)
    for light in lights:
        probe.AddLightConnection(light.GetOutputPort())
    probe.Update()
    weights = directions[:, 2] * angles
    answered = probe.GetOutput()
    view = common.array(answered.GetCellData(), "Visibility") @ (weights / weights.sum())
    values = numpy_to_vtk(view.astype(np.float32), deep=True)
    values.SetName("SkyView")
    answered.GetCellData().AddArray(values)
    return answered, view


def closed_form(x):
    """Of a street without end: the mean of the sines of the angles from overhead to the two eaves."""
    return 0.5 * sum(np.sin(np.arctan2(0.5 * WIDTH + side * x, HEIGHT)) for side in (-1.0, 1.0))


def main():
    options = common.parser(__doc__, size=1200)
    options.add_argument("--cells", type=int, default=24, help="cells across the street (default: 24)")
    options.add_argument("--samples", type=int, default=64, help="samples of each patch (default: 64)")
    arguments = common.parse(options)
    occluders = street()
    ground = vtkPlaneSource()
    ground.SetOrigin(-0.5 * WIDTH, -15.0, 0.0)
    ground.SetPoint1(0.5 * WIDTH, -15.0, 0.0)
    ground.SetPoint2(-0.5 * WIDTH, 15.0, 0.0)
    ground.SetResolution(arguments.cells, max(1, arguments.cells * 5 // 2))
    answered, view = sky_view(ground, occluders, arguments.samples)
    across = view[:arguments.cells]
    places = WIDTH * ((np.arange(arguments.cells) + 0.5) / arguments.cells - 0.5)
    wrong = across - closed_form(places)
    for at in (0, arguments.cells // 4, arguments.cells // 2):
        print(f"{places[at]:+6.2f} m from the middle of the street: {across[at]:.3f} of the sky's light, {closed_form(places[at]):.3f} by the "
              "closed form")
    print(f"root mean square of the difference across the street {np.sqrt(np.mean(wrong ** 2)):.4f}")

    renderer = vtkRenderer()
    table = common.color_table(0.0, MOST, bands=12)
    common.paint(renderer, answered, "SkyView", table, cells=True)
    common.add_actor(renderer, occluders.GetOutputPort(), common.GREY, ambient=0.3)
    camera = common.camera_at((0.0, -34.0, 27.0), (0.0, 1.0, 0.0), 26.0)
    picture = common.render(renderer, camera, arguments.size, arguments.size * 5 // 8)
    strip = common.legend(table, "Share of the sky's light that arrives on the ground", arguments.size, marks=7, form="{:.1f}")
    common.save(common.stack(picture, strip), os.path.join(arguments.output, "sky-view.png"), levels=64)


if __name__ == "__main__":
    main()
