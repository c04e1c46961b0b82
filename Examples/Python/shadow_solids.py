#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shadows as solids of what is truly seen: a house under the Sun, a ring under a lamp, cut open. Needs a display."""

import common
import scenes
import shadow_volume
import shadowcones as sc
from vtkmodules.vtkRenderingCore import vtkRenderer

SUN = "sun: direction 1,-1,0 diameter 2"  # four times the true diameter, to be seen
HOUSE_BOUNDS, RING_BOUNDS = (10.0, 45.0, 0.0, 20.0, -5.0, 15.0), (-2.7, 2.7, 0.0, 5.2, -2.7, 2.7)
# Where the camera stands, what it looks at, and its angle.
HOUSE_VIEW, RING_VIEW = ((32.0, 22.0, 62.0), (18.5, 9.0, 5.0), 31.0), ((3.0, 3.6, 9.0), (0.2, 1.35, 0.0), 29.0)


def picture(mesh, solids, z, view, size):
    """The halves behind a plane across z; the umbra a little in front of the cut face of the penumbra."""
    renderer = vtkRenderer()
    distance = view[0][2]
    penumbra, umbra = (shadow_volume.cut(solid, z) for solid in (solids.outer, solids.inner))
    # A little nearer to the light, so that what lies in one plane is not drawn in spots.
    common.add_actor(renderer, mesh, common.GREY, ambient=0.3).SetPosition(0.0, 0.001 * distance, 0.0)
    common.add_actor(renderer, umbra, shadow_volume.UMBRA, ambient=0.4).SetPosition(0.0, 0.0, 0.004 * distance)
    common.add_actor(renderer, penumbra, shadow_volume.PENUMBRA, ambient=0.35)
    return common.render(renderer, common.camera_at(*view, (0.0, 1.0, 0.0)), size, size * 3 // 4)


def main():
    options = common.parser(__doc__, size=700)
    options.add_argument("--resolution", type=int, default=64, help="cells along a solid's longest side (default: 64)")
    arguments = common.parse(options)
    pictures = []
    for name, mesh, light, bounds, z, view in (
            ("house", scenes.house(), SUN, HOUSE_BOUNDS, 5.02, HOUSE_VIEW),
            ("ring", scenes.ring(), scenes.ceiling_light(), RING_BOUNDS, 0.02, RING_VIEW)):
        solids = sc.shadow_solids({name: mesh}, light, bounds=bounds, resolution=arguments.resolution)
        print(name)
        shadow_volume.report("  penumbra", solids.outer)
        shadow_volume.report("  umbra", solids.inner)
        pictures.append(picture(mesh, solids, z, view, arguments.size))
    shown = common.table([pictures], ["a house under the Sun, cut open", "a ring under a lamp, cut open"])
    strip = common.key(((shadow_volume.PENUMBRA, "penumbra: a part of the light is hidden"),
                        (shadow_volume.UMBRA, "umbra: all of it is")), shown.shape[1])
    common.save(common.stack(shown, strip), f"{arguments.output}/shadow-solids.png", levels=64)


if __name__ == "__main__":
    main()
