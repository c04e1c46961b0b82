#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Germicidal light in a room with a pillar: the fluence rate in all of the air, and how much is in the pillar's shadow.

Writes uv-fluence.png, maps at two heights, and uv-fluence.vti, the volume. Two tubes shine up and down."""

import common
import drawing
import numpy as np
import scenes
import shadowcones as sc

PILLAR = (2.6, 3.1, 1.6, 2.1, 0.0, 3.0)  # in a room of 6 x 4 x 3 m
TUBES, LENGTH = ((0.4, 2.0, 2.6), (5.6, 1.0, 2.6)), 0.9  # of 6 W each, at 254 nm
HIGHEST, BANDS = 0.6, 24  # of the map, W m^-2


def plan(layer, width):
    """A map of the room from above, with the pillar and the tubes."""
    picture = drawing.colored(layer, HIGHEST, BANDS, width, 2 * width // 3)
    bars = [(PILLAR[:4], 0, 255)] + [((x, x, y - LENGTH / 2, y + LENGTH / 2), 2, 0) for x, y, _ in TUBES]
    for place, margin, color in bars:
        x0, x1, y0, y1 = np.round(np.array(place) / 6 * width).astype(int)
        picture[y0:y1, max(0, x0 - margin):x1 + margin] = color
    return picture


def main():
    options = common.parser(__doc__, size=1400)
    options.add_argument("--points", type=int, default=121, help="points along the room (default: 121)")
    options.add_argument("--samples", type=int, default=400, help="light samples a point (default: 400)")
    arguments = common.parse(options)
    pillar, count = scenes.label(scenes.box(*PILLAR)), arguments.points - 1
    volume = sc.vtkVisibilityVolume()
    for place in TUBES:
        volume.AddLightData(scenes.shining_tube(place, LENGTH, radius=0.013, power=6.0))
    volume.SetMeshConnection(pillar.GetOutputPort())
    volume.SetBounds(0.0, 6.0, 0.0, 4.0, 0.0, 3.0)
    volume.SetDimensions(count + 1, 2 * count // 3 + 1, count // 2 + 1)
    volume.SetNumberOfLightSamples(arguments.samples)
    volume.SetBrickParts(1)
    volume.ComputeFluenceRateOn()
    volume.Update()
    fluence, seen = (common.array(volume.GetOutput().GetPointData(), name) for name in ("FluenceRate", "Visibility"))
    print(f"fluence rate: median {np.median(fluence):.2f} W m^-2, a tenth of the air has less than "
          f"{np.quantile(fluence, 0.1):.2f}; {np.mean((seen < 1).any(axis=1)):.1%} of it lies in shadow of a tube")
    scenes.write_vti(volume.GetOutput(), f"{arguments.output}/uv-fluence.vti")

    layers = fluence.reshape(volume.GetOutput().GetDimensions()[::-1])
    maps = [plan(layers[round(height / 3 * (len(layers) - 1))], arguments.size // 2) for height in (1.6, 2.6)]
    picture = common.table([maps], ["1.6 m above the floor, at the head", "2.6 m, the height of the tubes"])
    title = "Fluence rate at 254 nm, W per square metre (white: the pillar; black: the tubes)"
    strip = common.legend(common.color_table(0.0, HIGHEST, BANDS), title, picture.shape[1], 7, "{:.1f}", " and more")
    common.save(common.stack(picture, strip), f"{arguments.output}/uv-fluence.png")


if __name__ == "__main__":
    main()
