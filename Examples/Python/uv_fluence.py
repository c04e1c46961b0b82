#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Germicidal light in a room with a pillar: the fluence rate in all of the air, and how much of it is in the pillar's shadow.

Writes uv-fluence.png, maps at two heights, and uv-fluence.vti, the volume. Two tubes under the ceiling shine up and down."""

import os

import common
import numpy as np
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

BOUNDS = (0.0, 6.0, 0.0, 4.0, 0.0, 3.0)
TUBES = ((0.4, 2.0, 2.6), (5.6, 1.0, 2.6))
POWER = 6.0    # W of each tube, at 254 nm
LENGTH, RADIUS = 0.9, 0.013
HIGHEST, BANDS = 0.6, 24  # of the map, W m^-2


def tube(place):
    """A tube along y that shines outward from its skin: power = pi x area x radiance."""
    skin = vtkCylinderSource()
    skin.SetCenter(*place)
    skin.SetHeight(LENGTH)
    skin.SetRadius(RADIUS)
    skin.SetResolution(16)
    skin.CappingOff()
    skin.Update()
    light = skin.GetOutput()
    area = 2 * 16 * RADIUS * np.sin(np.pi / 16) * LENGTH
    spectrum = common.numpy_to_vtk(np.array([POWER / (np.pi * area)]), deep=True)
    spectrum.SetName("LightSpectrum")
    light.GetFieldData().AddArray(spectrum)
    return light


def main():
    options = common.parser(__doc__, size=1400)
    options.add_argument("--points", type=int, default=121, help="points along the room (default: 121)")
    options.add_argument("--samples", type=int, default=400, help="light samples a point (default: 400)")
    arguments = common.parse(options)
    pillar = vtkCubeSource()
    pillar.SetBounds(2.6, 3.1, 1.6, 2.1, 0.0, 3.0)
    nx = arguments.points
    dimensions = (nx, 2 * (nx - 1) // 3 + 1, (nx - 1) // 2 + 1)
    volume = sc.vtkVisibilityVolume()
    for place in TUBES:
        volume.AddLightData(tube(place))
    volume.SetMeshConnection(pillar.GetOutputPort())
    volume.SetBounds(*BOUNDS)
    volume.SetDimensions(*dimensions)
    volume.SetNumberOfLightSamples(arguments.samples)
    volume.SetBrickParts(1)
    volume.ComputeFluenceRateOn()
    volume.Update()
    data = volume.GetOutput().GetPointData()
    fluence = common.array(data, "FluenceRate").reshape(dimensions[::-1])
    seen = common.array(data, "Visibility").reshape(dimensions[::-1] + (2,))
    print(f"fluence rate: median {np.median(fluence):.2f} W m^-2, a tenth of the air has less than "
          f"{np.quantile(fluence, 0.1):.2f}; {np.mean((seen < 1).any(axis=3)):.1%} of it lies in shadow of a tube")
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(volume.GetOutput())
    writer.SetFileName(os.path.join(arguments.output, "uv-fluence.vti"))
    writer.Write()

    width = arguments.size // 2
    height = 2 * width // 3
    pictures = []
    for level in (1.6, 2.6):
        layer = fluence[round(level / 3.0 * (dimensions[2] - 1))]
        rows, columns = np.linspace(0, layer.shape[0] - 1, height), np.linspace(0, layer.shape[1] - 1, width)
        layer = np.array([np.interp(columns, np.arange(layer.shape[1]), row) for row in layer])
        layer = np.array([np.interp(rows, np.arange(layer.shape[0]), column) for column in layer.T]).T
        colors = common.scale(BANDS)[np.clip(layer / HIGHEST * BANDS, 0, BANDS - 1).astype(int)].round().astype(np.uint8)
        x, y = (np.array([2.6, 3.1]) / 6 * width).astype(int), (np.array([1.6, 2.1]) / 4 * height).astype(int)
        colors[y[0]:y[1], x[0]:x[1]] = 255
        for place in TUBES:  # seen from above
            x, y = round(place[0] / 6 * width), (np.array([place[1] - LENGTH / 2, place[1] + LENGTH / 2]) / 4 * height).astype(int)
            colors[y[0]:y[1], max(0, x - 2):x + 3] = (0, 0, 0)
        pictures.append(colors)
    picture = common.table([pictures], ["1.6 m above the floor, at the head", "2.6 m, the height of the tubes"])
    title = "Fluence rate at 254 nm, W per square metre (white: the pillar; black: the tubes)"
    strip = common.legend(common.color_table(0.0, HIGHEST, BANDS), title, picture.shape[1], 7, "{:.1f}", " and more")
    common.save(common.stack(picture, strip), os.path.join(arguments.output, "uv-fluence.png"))


if __name__ == "__main__":
    main()
