#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shadow photons on the next surface, and shadow vectors on the back side (the paper's figure 2). Drawing needs a display."""

import common
import diagrams
import numpy as np
import scenes
import shadowcones as sc

LAMP, RADIUS = 4.0, 0.4
BOX = (-0.9, 0.9, 1.7, 2.3, -1.2, 1.2)


def scene():
    """A lamp above a box above a floor, which casts no shadow."""
    light = sc.vtkAreaLightSource()
    light.SetCenter(0.0, LAMP, 0.0)
    light.SetNormal(0.0, -1.0, 0.0)
    light.SetRadius(RADIUS)
    box = scenes.label(scenes.solid(*BOX))
    box.Update()
    floor = common.receivers(scenes.sheet((-3.0, 0.0, 3.0), (6.0, 0.0, 0.0), (0.0, 0.0, -6.0), (1, 1)))
    return scenes.joined([box.GetOutput(), floor]), light


def base(paths):
    """Lamp, box and floor from the side, and the ways of the photons that the box stops."""
    drawing = diagrams.Drawing()
    drawing.area(diagrams.rectangle(*BOX[:4]), common.GREY)
    starts, ends = common.array(paths.GetPointData(), "EmissionPoint")[:, :2], diagrams.places(paths)[:, :2]
    blocked = common.array(paths.GetPointData(), "PathState") == 1
    drawing.lines(starts[blocked], ends[blocked], (0.55, 0.55, 0.55), 0.8)
    drawing.path([(-2.6, 0.0), (2.6, 0.0)], common.INK, 2.0)
    drawing.path([(-RADIUS, LAMP), (RADIUS, LAMP)], common.ORANGE, 6.0)
    drawing.say("lamp", (0.0, LAMP + 0.08))
    drawing.say("occluder", (-1.55, 1.92))
    drawing.say("next surface", (-1.75, -0.36))
    return drawing


def main():
    arguments = common.parse(common.parser(__doc__, size=620, vectors=40))
    room, light = scene()
    vectors = sc.vtkShadowVectorFilter()
    vectors.SetToPaper()
    vectors.SetInputData(room)
    vectors.SetLightConnection(light.GetOutputPort())
    vectors.SetTargetNumberOfVectors(arguments.vectors)
    vectors.Update()
    found, paths, photons = (vectors.GetOutput(port) for port in range(3))
    print(f"{paths.GetNumberOfPoints()} photons, {found.GetNumberOfPoints()} shadow vectors, {photons.GetNumberOfPoints()} shadow photons")

    left, right = base(paths), base(paths)
    starts, ways = diagrams.places(found), common.array(found.GetPointData(), "Direction")
    index = {photon: k for k, photon in enumerate(common.array(found.GetPointData(), "PhotonIndex"))}
    for place, photon in zip(diagrams.places(photons), common.array(photons.GetPointData(), "PhotonIndex")):
        left.dashes(starts[index[photon], :2], place[:2], (0.45, 0.45, 0.45), width=0.8)
    left.dots(diagrams.places(photons)[:, :2], common.DARK_BLUE, 0.045)
    right.arrows(starts[:, :2], (starts + 0.7 * ways)[:, :2], common.GREEN)
    pictures = [drawing.picture((-2.6, -0.4), (2.6, 4.4), arguments.size) for drawing in (left, right)]
    picture = common.table([pictures], ["a: shadow photons (output 2)", "b: shadow vectors (output 0)"])
    entries = (((0.55, 0.55, 0.55), "photon paths"), (common.DARK_BLUE, "shadow photons"),
               (common.GREEN, "shadow vectors"))
    common.save(common.stack(picture, common.key(entries, picture.shape[1])), f"{arguments.output}/figure2.png", levels=64)


if __name__ == "__main__":
    main()
