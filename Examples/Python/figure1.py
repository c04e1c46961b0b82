#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A bar, its shadow and its cones (the paper's figure 1): under a point of light, and under a disc. Drawing needs a display."""

import common
import diagrams
import numpy as np
import scenes
import shadowcones as sc

HALF, TOP, BOTTOM, LAMP, RADIUS = 0.9, 2.26, 2.2, 4.0, 0.4  # of the bar, and the lamp's height and radius


def panel(radius, number, size):
    """The bar from its side, with what a lamp of this radius makes; 0: a point."""
    light = sc.vtkAreaLightSource()
    light.SetCenter(0.0, LAMP, 0.0)
    light.SetNormal(0.0, -1.0, 0.0)
    light.SetRadius(radius or 1.0)
    if not radius:
        light.SetShapeToPoint()
    bar = scenes.label(scenes.solid(-HALF, HALF, BOTTOM, TOP, -0.12, 0.12))
    vectors = common.shadow_vectors(bar, light, number)
    cones = common.cone_set(vectors)
    geometry = sc.vtkConeSetGeometry()
    geometry.SetInputConnection(cones.GetOutputPort())
    geometry.SetCutToPlane()  # the floor
    geometry.Update()
    angles = np.degrees(common.array(cones.GetOutput().GetPointData(), "HalfAngle"))
    print(f"radius {radius}: {common.summary(cones)}; half angles {angles.min():.1f} to {angles.max():.1f} degrees", flush=True)

    drawing = diagrams.Drawing()
    drawing.show(geometry.GetOutputPort(0), common.BLUE, opacity=0.09)
    found = vectors.GetOutput()
    starts, ways = diagrams.places(found), common.array(found.GetPointData(), "Direction")
    few = slice(0, None, max(1, len(starts) // 40))
    drawing.arrows(starts[few, :2], (starts + 0.45 * ways)[few, :2], common.GREEN, head=0.07)
    drawing.area(diagrams.rectangle(-HALF, HALF, BOTTOM, TOP), (0.35, 0.35, 0.35))
    low, high = geometry.GetOutput(1).GetBounds()[:2]
    drawing.path([(low, BOTTOM - 0.02), (high, BOTTOM - 0.02)], common.RED, 3.0)
    drawing.path([(-2.75, 0.0), (2.75, 0.0)], common.INK)
    for side in (-1.0, 1.0):
        for end in {-radius, radius}:  # a line from each end of the lamp by way of the bar's end
            edge = np.array([side * HALF, TOP if side * end < side * HALF else BOTTOM])
            floor = edge + (edge - (end, LAMP)) * edge[1] / (LAMP - edge[1])
            drawing.dashes((end, LAMP), floor, common.INK, width=1.2)
    drawing.path([(-max(radius, 0.03), LAMP), (max(radius, 0.03), LAMP)], common.ORANGE, 6.0)
    drawing.say("lamp", (0.0, LAMP + 0.08))
    drawing.say("bar", (-HALF - 0.3, BOTTOM - 0.05))
    drawing.say("umbra", (0.0, -0.34))
    if radius:
        drawing.say("penumbra", (-2.05, -0.34))
        drawing.say("penumbra", (2.05, -0.34))
    return drawing.picture((-2.75, -0.4), (2.75, 4.4), size)


def main():
    arguments = common.parse(common.parser(__doc__, size=620, vectors=900))
    pictures = [panel(radius, arguments.vectors, arguments.size) for radius in (0.0, RADIUS)]
    picture = common.table([pictures], ["a: a point of light", "b: a disc of light"])
    entries = ((common.GREEN, "shadow vectors"), (common.RED, "bases"), (common.BLUE, "cones"), (common.INK, "true edges"))
    common.save(common.stack(picture, common.key(entries, picture.shape[1])), f"{arguments.output}/figure1.png", levels=64)


if __name__ == "__main__":
    main()
