#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A lamp that moves in a circle over a chair, a ball and a screen: irradiance on the floor as an animated PNG."""

import os

import common
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkRenderer

HIGHEST = 1.2  # of the map, W m^-2


def main():
    options = common.parser(__doc__, 1000)
    options.add_argument("--frames", type=int, default=24, help="pictures of a round (default: 24)")
    options.add_argument("--cells", type=int, default=300, help="cells along the floor (default: 300)")
    options.add_argument("--samples", type=int, default=144, help="of the lamp, a point (default: 144)")
    arguments = common.parse(options)
    screen = vtkCubeSource()
    screen.SetBounds(1.6, 1.68, 0, 1.5, -1.2, 1.0)
    things = {"chair": scenes.read(os.path.join(arguments.data, "chair.vtp")), "ball": scenes.ball((-2.2, 0.5, 0.8), 0.5, 64), "screen": screen}
    floor = vtkPlaneSource()
    floor.SetOrigin(-4.5, 0, 3)
    floor.SetPoint1(4.5, 0, 3)
    floor.SetPoint2(-4.5, 0, -3)
    floor.SetResolution(arguments.cells, arguments.cells * 2 // 3)
    table = common.color_table(0.0, HIGHEST, bands=16)
    frames, size = [], arguments.size
    for turn in np.arange(arguments.frames) / arguments.frames * 2.0 * np.pi:
        lamp = (2.6 * np.cos(turn), 3.4, 1.7 * np.sin(turn))
        renderer = vtkRenderer()
        words = "sphere:{:f},{:f},{:f} radius 0.2 flux 150 W wavelengths 1".format(*lamp)
        answered = sc.irradiance(floor, things, words, samples=arguments.samples)
        common.paint(renderer, answered, "Irradiance", table)
        for thing in things.values():
            common.add_actor(renderer, thing, common.GREY, ambient=0.3)
        common.add_actor(renderer, scenes.ball(lamp, 0.2, 64), common.ORANGE, ambient=1.0)
        camera = common.camera_at((0.0, 6.4, 9.6), (0.0, 0.85, 0.1), 33.0, (0, 1, 0))
        strip = common.legend(table, "Irradiance on the floor, W per square metre", size, 7, "{:.1f}", " and more")
        frames.append(common.stack(common.render(renderer, camera, size, size * 27 // 50), strip))
    common.save(frames, f"{arguments.output}/moving-lamp.png", 24, seconds=2.4 / arguments.frames)


if __name__ == "__main__":
    main()
