#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""An eclipse in space: the Moon's umbra and penumbra on their way to the Earth, and on it. Sizes and distances are not to scale."""

import common
import numpy as np
import scenes
import shadow_volume
import shadowcones as sc
from vtkmodules.vtkRenderingCore import vtkRenderer

SUN, MOON, EARTH = ((-7.0, 0.0, 0.0), 1.5), ((0.0, 0.0, 0.0), 0.5), ((4.7, 0.1, 0.0), 1.95)  # place and radius
LIT, PENUMBRA, UMBRA = (0.98, 0.91, 0.62), (0.55, 0.60, 0.70), (0.05, 0.10, 0.28)


def main():
    options = common.parser(__doc__, 1200)
    options.add_argument("--cells", type=int, default=300, help="cells around the Earth (default: 300)")
    options.add_argument("--samples", type=int, default=256, help="of the Sun, a cell of the Earth (default: 256)")
    options.add_argument("--resolution", type=int, default=64, help="cells along the solids of shadow (default: 64)")
    arguments = common.parse(options)
    sun, moon, size = "sphere:{},{},{} radius {}".format(*SUN[0], SUN[1]), scenes.ball(*MOON, 128), arguments.size
    renderer = vtkRenderer()
    solids = sc.shadow_solids(moon, sun, bounds=(0, 4.7, -2.2, 2.2, -2.2, 2.2), resolution=arguments.resolution)
    for solid, color, nearer in ((solids.outer, PENUMBRA, 0.0), (solids.inner, UMBRA, 0.01)):
        common.add_actor(renderer, shadow_volume.cut(solid, 0.0), color, ambient=0.5).SetPosition(0, 0, nearer)
    earth = scenes.ball(*EARTH, arguments.cells)  # its night is its own shadow
    earth = sc.visibility(earth, [moon, earth], sun, cells=True, samples=arguments.samples)
    look = common.paint(renderer, earth, "ShadowClass", common.category_table((LIT, PENUMBRA, UMBRA)), cells=True).GetProperty()
    look.SetAmbient(0.55)
    look.SetDiffuse(0.45)
    for body, color in ((SUN, common.YELLOW), (MOON, common.GREY)):
        common.add_actor(renderer, scenes.ball(*body, 128), color, ambient=0.4)
    for words, (place, radius) in (("Sun", SUN), ("Moon", MOON), ("Earth", EARTH)):
        common.add_label(renderer, words, np.add(place, (0, radius + 0.12, 0)), size // 45)
    picture = common.render(renderer, common.camera_at((-9.0, 5.5, 20.0), (-0.7, 0.1, 0), 22.0, (0, 1, 0)), size, size * 9 // 20)
    strip = common.key(((LIT, "lit: all of the Sun is seen"), (PENUMBRA, "penumbra: a part of it"), (UMBRA, "umbra: none of it")), size)
    common.save(common.stack(picture, strip), f"{arguments.output}/eclipse.png")


if __name__ == "__main__":
    main()
