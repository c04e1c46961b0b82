#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A chair on a stage under a red, a green and a blue spotlight: together they are white, and their shadows are coloured."""

import os

import common
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkConeSource

STAGE = (-6, 6, 0, 6, -4, 4)
TARGET = np.array((0.0, 0.4, 0.0))
# Where a lamp hangs, and its intensity at seven wavelengths, from blue to red.
LAMPS = (((-3.6, 5.2, 1.2), "0,0,0,0,60,60,60"), ((0.0, 5.6, 1.9), "0,0,40,40,0,0,0"), ((3.6, 5.2, 1.2), "90,90,0,0,0,0,0"))


def spotlight(place, radiance):
    """A point of light in a cone that is open in front: the words of the lamp, and the cone."""
    facing = (TARGET - place) / np.linalg.norm(TARGET - place)
    hood = vtkConeSource()
    hood.SetHeight(0.6)
    hood.SetRadius(0.17)
    hood.SetResolution(64)
    hood.SetCenter(*(place + 0.22 * facing))
    hood.SetDirection(*-facing)
    hood.CappingOff()
    return "point:{:f},{:f},{:f} radiance ".format(*place) + radiance, common.painted(hood, 0.05, 0.05, 0.05)


def main():
    options = common.parser(__doc__, 1200)
    options.add_argument("--goal", type=float, default=0.05, help="relative error of a pixel (default: 0.05)")
    arguments = common.parse(options)
    lamps, tubes = zip(*[spotlight(np.array(place), radiance) for place, radiance in LAMPS])
    chair = common.turned(scenes.read(os.path.join(arguments.data, "chair.vtp")), (0, 0, 0), -28, (0, 1, 0), 0.6)
    room = [common.painted(common.brick(*bounds), 0.5, 0.5, 0.5) for bounds in ((-6, 6, -0.1, 0, -4, 4), (-6, 6, 0, 6, -4.1, -4))]
    shot = sc.light_shafts([*room, *tubes, common.painted(chair, 0.7, 0.7, 0.7)], list(lamps),
                           common.camera_at((0.0, 3.4, 10.0), (0.0, 2.3, 0.0), 34.0, (0, 1, 0)),
                           (arguments.size, arguments.size * 5 // 8), arguments.goal, medium=STAGE, sigma_s=0.05, asymmetry=0.3)
    shot.save(f"{arguments.output}/stage.png")
    print(f"wrote {arguments.output}/stage.png: {shot}")


if __name__ == "__main__":
    main()
