#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A small museum: lux on the walls, the floor and the pedestals under two lamps, and where a limit for paper is passed.

Writes irradiance.png: illuminance, and the places that get more than a limit of 150 lux. Drawing needs a display."""

import common
import drawing
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource
from vtkmodules.vtkRenderingCore import vtkRenderer

LIMIT, HIGHEST = 150.0, 300.0  # lux; of the maps
LAMPS = ((-1.3, -0.5, 5000.0), (1.4, 0.4, 3600.0))  # x, y, lumen; of round panels at 3.4 m
GREY = (0.6, 0.6, 0.6)


def view(answered, table, size):
    """From the open side of the room."""
    renderer = vtkRenderer()
    common.paint(renderer, answered, "Irradiance", table)
    for x, y, _ in LAMPS:
        disc = vtkRegularPolygonSource()
        disc.SetCenter(x, y, 3.4)
        disc.SetRadius(0.2)
        disc.SetNumberOfSides(48)
        common.add_actor(renderer, disc, common.YELLOW, ambient=1.0)
    return common.render(renderer, common.camera_at((4.9, -9.2, 5.4), (-0.05, 0.0, 1.3), 29.0), size, size * 3 // 4)


def main():
    options = common.parser(__doc__, size=740)
    options.add_argument("--points", type=int, default=91, help="points along floor and walls (default: 91)")
    options.add_argument("--samples", type=int, default=128, help="light samples a point (default: 128)")
    arguments = common.parse(options)
    # One wavelength, and a lumen for every watt: what arrives is lux.
    lamps = [f"disc:{x},{y},3.4 radius 0.2 facing -z flux {lumen} W wavelengths 1" for x, y, lumen in LAMPS]
    things = scenes.exhibits()
    answered = sc.irradiance(scenes.museum(things, arguments.points), things, lamps, samples=arguments.samples)
    lux = common.array(answered.GetPointData(), "Irradiance")
    error = common.array(answered.GetPointData(), "IrradianceError")
    print(f"{len(lux):,} places: up to {lux.max():.0f} lux, {np.mean(lux > LIMIT):.1%} of them above {LIMIT:.0f} lux; "
          f"largest standard error {error.max():.1f} lux")

    table = common.color_table(0.0, HIGHEST, bands=12)
    limit = drawing.limit_table(LIMIT, HIGHEST, common.VERMILION)
    pictures = [view(answered, colors, arguments.size) for colors in (table, limit)]
    picture = common.table([pictures], ["illuminance", f"more than {LIMIT:.0f} lux, the limit for paper"])
    scale = common.legend(table, "Illuminance, lux", picture.shape[1], marks=7, more=" and more")
    key = common.key([(GREY, f"up to {LIMIT:.0f} lux"), (common.VERMILION, f"above {LIMIT:.0f} lux"),
                      (common.YELLOW, "lamps")], picture.shape[1])
    common.save(common.stack(picture, scale, key), f"{arguments.output}/irradiance.png", 64)


if __name__ == "__main__":
    main()
