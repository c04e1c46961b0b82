#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A camera ray in a real cone set (the paper's figure 6): the interval of every cone, what they cover together, and the visible
share of the lamp along the ray, asked of the mesh. Drawing needs a display."""

import by_hand
import common
import diagrams
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkLineSource

EYE, THROUGH = np.array([0.0, 2.75, 12.5]), np.array([0.12, 1.05, 0.0])  # the camera, and a place under the seat


def visible(light, occluders, cones, begin, end, points):
    """The visible share of the lamp between two places, from rays inside cones."""
    line = vtkLineSource()
    line.SetPoint1(*begin)
    line.SetPoint2(*end)
    line.SetResolution(points - 1)
    probe = sc.vtkConeSetProbe()
    probe.SetInputConnection(line.GetOutputPort())
    probe.SetConeSetConnection(cones.GetOutputPort())
    probe.SetLightConnection(light.GetOutputPort())
    probe.SetMeshConnection(occluders.GetOutputPort())
    probe.SetMethodToExact()
    probe.SetNumberOfLightSamples(1024)
    probe.Update()
    return common.array(probe.GetOutput().GetPointData(), "Visibility")


def main():
    options = common.parser(__doc__, size=1100, vectors=5800)
    options.add_argument("--points", type=int, default=400, help="on the ray (default: 400)")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    chair = scenes.label(scenes.read(f"{arguments.data}/chair.vtp"))
    cones = common.cone_set(common.shadow_vectors(chair, light, arguments.vectors))
    print(common.summary(cones), flush=True)
    way = by_hand.unit(THROUGH - EYE)
    begin, end = sorted((z - EYE[2]) / way[2] for z in scenes.MEDIUM_BOUNDS[4:])
    which, each = by_hand.ray_intervals(EYE, way, begin, end, cones.GetOutput())
    together = by_hand.union(each)
    print(f"{len(each)} cones are met, {len(together)} intervals together, {np.sum(np.diff(together)):.2f} of {end - begin:.2f} long")
    t = np.linspace(begin, end, arguments.points)
    seen = visible(light, chair, cones, EYE + begin * way, EYE + end * way, arguments.points)
    covered = np.any((t[:, np.newaxis] >= together[:, 0]) & (t[:, np.newaxis] <= together[:, 1]), axis=1)
    print(f"{np.mean(seen < 1.0):.1%} of the ray is in shadow, {np.mean((seen < 1.0) & ~covered):.1%} outside of all intervals")

    # Over the ray: the room in the plane of the ray. Below: everything on the ray's own length.
    up = by_hand.unit(np.cross(np.cross(way, (0.0, 1.0, 0.0)), way))
    drawing = diagrams.Drawing(view=np.cross(up, way), up=up)
    geometry = sc.vtkConeSetGeometry()
    geometry.SetInputData(by_hand.some_cones(cones.GetOutput(), which))
    geometry.SetCutToBox()
    geometry.SetBoxBounds(*scenes.MEDIUM_BOUNDS)
    drawing.show(geometry.GetOutputPort(0), common.BLUE, opacity=0.1)
    drawing.show(chair, common.GREY, ambient=0.5)
    near = EYE - 5.0 * drawing.view  # in front of everything
    drawing.path([near + begin * way, near + end * way], common.INK, 1.5)
    drawing.lines(near + np.outer(together[:, 0], way), near + np.outer(together[:, 1], way), common.VERMILION, 3.5)
    level = EYE @ up
    above = drawing.picture((EYE @ way + begin - 0.9, level - 1.3), (EYE @ way + end + 0.1, level + 1.9), arguments.size)
    below = diagrams.Drawing()
    order = np.argsort(each[:, 0])
    rows = np.linspace(0.0, 1.0, len(each) + 2)[1:-1]
    below.lines(np.stack([each[order, 0], rows], axis=1), np.stack([each[order, 1], rows], axis=1), common.BLUE, 2.0)
    for first, last in together:
        below.area(diagrams.rectangle(first, last, -0.16, -0.06), common.VERMILION)
        for edge in (first, last):
            below.dashes((edge, -1.4), (edge, 1.0), diagrams.PALE, dash=0.02, width=1.0)
    below.path(np.stack([t, seen - 1.4], axis=1), common.INK, 2.0)
    words = {f"{len(each)} cones": 0.5, "together": -0.16, "visible": -0.85, "share": -1.02}
    for word, height in words.items():
        below.say(word, (begin - 0.5, height), size=0.75)
    for value in (0, 1):
        below.say(str(value), (begin - 0.09, value - 1.44), size=0.6)
    below.say("distance from the camera", (0.5 * (begin + end), -1.85), size=0.75)
    for mark in range(int(np.ceil(begin)), int(end) + 1):
        below.say(str(mark), (mark, -1.62), size=0.7)
        below.path([(mark, -1.44), (mark, -1.4)], common.INK, 1.0)
    below.path([(begin, -1.4), (end, -1.4)], common.INK, 1.0)
    picture = below.picture((begin - 0.9, -1.95), (end + 0.1, 1.1), arguments.size)
    entries = ((common.INK, "the ray; visible share"), (common.BLUE, "cones, their intervals"), (common.VERMILION, "the intervals together"))
    common.save(common.stack(above, picture, common.key(entries, arguments.size)), f"{arguments.output}/figure6.png", levels=64)


if __name__ == "__main__":
    main()
