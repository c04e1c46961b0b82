#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The chair's shadow as a volume: filled once from the cones, then rendered, sliced and saved.

Writes visibility-volume.vti, the volume with its bricks, and visibility-volume.png, the shadow in space and a cut
through it. With --window the volume turns in a window of its own instead. Drawing needs a display."""

import common
import drawing
import numpy as np
import scenes
from vtkmodules.vtkRenderingCore import vtkRenderer


def report(image):
    """One line on what was filled."""
    marked, classes = (common.array(image.GetPointData(), name) for name in ("Marked", "ShadowClass"))
    rays, bricks = (image.GetFieldData().GetArray(name) for name in ("NumberOfOcclusionRays", "BrickCells"))
    print(f"{classes.size:,} points, {np.mean(marked):.1%} asked for with {rays.GetTuple1(0):,.0f} rays, "
          f"{np.mean(classes == 1):.1%} in penumbra, {np.mean(classes == 2):.1%} in umbra, "
          f"{bricks.GetNumberOfTuples() if bricks else 0:,} cells refined", flush=True)


def main():
    options = common.parser(__doc__, size=700, vectors=20000)
    options.add_argument("--points", type=int, default=65, help="points along a side of the volume (default: 65)")
    options.add_argument("--window", action="store_true", help="show the volume in a window, and write no picture")
    arguments = common.parse(options)
    chair = scenes.label(scenes.read(f"{arguments.data}/chair.vtp"))
    light = scenes.ceiling_light()
    cones = common.tuned_cones(chair, light, arguments.vectors, "Conservative")
    volume = common.visibility_volume(chair, light, cones)
    volume.SetDimensions(arguments.points, arguments.points, arguments.points)
    volume.SetNumberOfLightSamples(64)  # 16 do for images; a cut shows the noise of every point
    volume.Update()
    report(volume.GetOutput())
    scenes.write_vti(volume.GetOutput(), f"{arguments.output}/visibility-volume.vti")
    space, cut, table = vtkRenderer(), vtkRenderer(), common.color_table(0.0, 1.0)
    drawing.add_smoke(space, volume)
    drawing.add_cut(cut, volume, "Visibility", table, origin=(0.003, 0.0, 0.0), normal=(1.0, 0.0, 0.0))
    views = []
    for renderer, position in ((space, (4.5, 3.6, 10.0)), (cut, (11.0, 2.0, 0.0))):
        common.add_actor(renderer, chair, common.GREY, ambient=0.4)
        views.append((renderer, common.camera_at(position, (0.0, 1.6, 0.0), 24.0, (0.0, 1.0, 0.0))))
    if arguments.window:
        drawing.show_in_window(*views[0], 2 * arguments.size, "The visible share of the lamp")
        return
    pictures = [common.render(renderer, camera, arguments.size) for renderer, camera in views]
    picture = common.table([pictures], ["the shadow in space, as smoke", "a cut through it"])
    strip = common.legend(table, "Visible share of the lamp", picture.shape[1], marks=6, form="{:.1f}")
    common.save(common.stack(picture, strip), f"{arguments.output}/visibility-volume.png", 64)


if __name__ == "__main__":
    main()
