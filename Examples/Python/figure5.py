#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The base radius r cos(theta) of a cone behind a slanted plate (the paper's figure 5). Drawing needs a display."""

import common
import diagrams
import numpy as np
import scenes
import shadowcones as sc

TILT = 50.0  # degrees


def slanted(vectors):
    """The cone nearest to the middle of the plate: its arrays, and its radius in the plane of the plate."""
    radii = []
    for corrected in (True, False):
        cones = common.cone_set(vectors)
        cones.SetCosineCorrection(corrected)
        cones.Update()
        points = cones.GetOutput().GetPointData()
        centers = diagrams.places(cones.GetOutput())
        cone = np.argmin(np.linalg.norm(centers, axis=1))
        radii.append(common.array(points, "BaseRadius")[cone])
    axis, normal = (common.array(points, name)[cone].astype(float) for name in ("Axis", "Normal"))
    return centers[cone], axis, normal, radii[1], radii[0]


def main():
    arguments = common.parse(common.parser(__doc__, size=760, vectors=700))
    slope = np.array([np.cos(np.radians(TILT)), np.sin(np.radians(TILT)), 0.0])
    plate = scenes.label(scenes.sheet(-slope + (0.0, 0.0, 1.0), 2.0 * slope, (0.0, 0.0, -2.0), (1, 1)))
    light = sc.vtkAreaLightSource()
    light.SetCenter(0.0, 6.0, 0.0)
    light.SetNormal(0.0, -1.0, 0.0)
    light.SetRadius(0.5)
    vectors = common.shadow_vectors(plate, light, arguments.vectors)
    center, axis, normal, r, projected = slanted(vectors)
    cosine = axis @ normal
    print(f"r = {r:.4f}, theta = {np.degrees(np.arccos(cosine)):.1f} degrees, r cos(theta) = {r * cosine:.4f}, "
          f"BaseRadius = {projected:.4f}")
    assert np.isclose(r * cosine, projected, rtol=1e-5)
    assert np.isclose(cosine, np.cos(np.radians(TILT)), atol=0.05)

    drawing = diagrams.Drawing()
    across = np.cross((0.0, 0.0, 1.0), axis)
    ends = [center + side * r * slope for side in (-1.0, 1.0)]
    feet = [center + side * projected * across for side in (-1.0, 1.0)]
    drawing.path([-1.6 * r * slope + center, 1.6 * r * slope + center], (0.6, 0.6, 0.6), 7.0)
    points, ways = diagrams.places(vectors.GetOutput()), common.array(vectors.GetOutput().GetPointData(), "Direction")
    inside = np.linalg.norm(points - center, axis=1) <= r
    drawing.arrows(points[inside][::5], (points + 0.6 * r * ways)[inside][::5], common.GREEN, head=0.07 * r, width=1.0)
    for end, foot in zip(sorted(ends, key=lambda p: p[0]), sorted(feet, key=lambda p: p[0])):
        drawing.dashes(end + 0.9 * r * axis, end - 0.9 * r * axis, common.INK, dash=0.05 * r, width=1.0)
    drawing.path(ends, common.ORANGE, 4.0)
    drawing.path(feet, common.RED, 4.0)
    drawing.arrows([center], [center + 1.3 * r * axis], common.BLUE, head=0.14 * r, width=2.5)
    drawing.arrows([center], [center + 1.1 * r * normal], common.INK, head=0.14 * r, width=2.0)
    turn = [np.degrees(np.arctan2(way[1], way[0])) for way in (axis, normal)]
    drawing.path(diagrams.circle(center[:2], 0.55 * r, *sorted(turn)), common.INK)
    middle = np.radians(0.5 * sum(turn))
    drawing.say("theta", center[:2] + 0.7 * r * np.array([np.cos(middle), np.sin(middle)]) - (0.0, 0.05 * r))
    drawing.say("r", center + 0.5 * r * slope + (-0.12 * r, 0.0, 0.0))
    drawing.say("r cos(theta)", feet[0] + (-0.38 * r, -0.05 * r, 0.0), common.RED)
    drawing.say("mean direction", center + 1.45 * r * axis, common.BLUE)
    drawing.say("normal", center + 1.15 * r * normal + (0.2 * r, -0.02 * r, 0.0))
    picture = drawing.picture(center[:2] - (1.5 * r, 1.6 * r), center[:2] + (1.5 * r, 1.15 * r), arguments.size)
    common.save(picture, f"{arguments.output}/figure5.png", levels=64)


if __name__ == "__main__":
    main()
