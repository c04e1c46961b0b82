#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sun through blinds into a hazy room: beams between the slats, their stripes on table and floor."""

import common
import numpy as np
from common import brick, painted
import shadowcones as sc

ROOM = (0, 6, 0, 3, -2, 2)


def blinds(number):
    """Slats across the window, turned a little against the Sun."""
    slats = []
    for height in np.linspace(1.0, 2.4, number):
        points, faces = brick(-0.11, 0.0, height, height + 0.006, -1.2, 1.2)
        slats.append(painted(([(x, y + 0.55 * (x + 0.055), z) for x, y, z in points], faces), 0.8, 0.8, 0.8))
    return slats


def room():
    """A wall with a window, a floor, a ceiling, three more walls, a table."""
    walls = [brick(-0.1, 0, 0, 0.9, -2, 2), brick(-0.1, 0, 2.5, 3, -2, 2), brick(-0.1, 0, 0.9, 2.5, -2, -1.2),
             brick(-0.1, 0, 0.9, 2.5, 1.2, 2), brick(0, 6, -0.1, 0, -2, 2), brick(0, 6, 3, 3.1, -2, 2),
             brick(6, 6.1, 0, 3, -2, 2), brick(0, 6, 0, 3, -2.1, -2), brick(0, 6, 0, 3, 2, 2.1)]
    table = [brick(2.2, 3.4, 0.7, 0.75, -0.6, 0.6)]
    table += [brick(x, x + 0.06, 0, 0.7, z, z + 0.06) for x in (2.25, 3.3) for z in (-0.55, 0.5)]
    return [painted(wall, 0.75, 0.72, 0.68) for wall in walls] + [painted(part, 0.5, 0.3, 0.16) for part in table]


def main():
    options = common.parser(__doc__, 1200)
    options.add_argument("--goal", type=float, default=0.02, help="relative error of a pixel (default: 0.02)")
    arguments = common.parse(options)
    sun = "sun: direction 1,-0.42,-0.12 irradiance 800 W/m2 spectrum .6,.72,.85,.95,1,1,1"
    camera = common.camera_at((4.6, 1.75, 1.85), (1.7, 1.15, -0.25), 58.0, (0, 1, 0))
    shot = sc.light_shafts(room() + blinds(8), sun, camera, (arguments.size, arguments.size * 5 // 8), arguments.goal, medium=ROOM,
                           sigma_s=0.12, asymmetry=0.4)
    shot.save(f"{arguments.output}/blinds.png")
    print(f"wrote {arguments.output}/blinds.png: {shot}")


if __name__ == "__main__":
    main()
