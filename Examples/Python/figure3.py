#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bases that spill over the edges of a plate, and bases that hardly do (the paper's figure 3). Drawing needs a display."""

import common
import diagrams
import numpy as np
import scenes


def panel(threshold, vectors, plate, size):
    """The plate and the bases from the lamp, and a title."""
    cones = common.cone_set(vectors)
    cones.SetVarianceThreshold(threshold)
    cones.Update()
    points = cones.GetOutput().GetPointData()
    radii, spilled = common.array(points, "BaseRadius"), common.array(points, "Overspill")
    share = np.average(spilled, weights=radii ** 2)
    print(f"VarianceThreshold {threshold}: {common.summary(cones)}; overspill {share:.1%} of the bases' area, "
          f"{spilled.max():.0%} of the worst", flush=True)
    drawing = diagrams.Drawing(view=(0.0, -1.0, 0.0), up=(0.0, 0.0, -1.0))
    drawing.show(plate, common.GREY)
    drawing.dots(diagrams.places(vectors.GetOutput()), common.GREEN, 0.006)
    for center, radius in zip(diagrams.places(cones.GetOutput()), radii):
        rim = center + np.insert(diagrams.circle((0.0, 0.0), radius), 1, 0.0, axis=1)
        drawing.area(rim, common.RED, opacity=0.22)
        drawing.path(rim, common.RED, 1.2)
    title = f"threshold {threshold}: {len(radii)} bases, {share:.1%} spilled"
    return drawing.picture((-1.25, -1.25), (1.25, 1.25), size), title


def main():
    options = common.parser(__doc__, size=620, vectors=3000)
    options.add_argument("--thresholds", type=float, nargs=2, default=(2.5, 1.2),
                         help="a loose and a strict VarianceThreshold (default: 2.5 and 1.2)")
    arguments = common.parse(options)
    plate = scenes.label(scenes.l_plate())
    vectors = common.shadow_vectors(plate, scenes.ceiling_light(), arguments.vectors)
    panels = [panel(threshold, vectors, plate.GetOutputPort(), arguments.size) for threshold in arguments.thresholds]
    picture = common.table([[picture for picture, _ in panels]], [f"{name}: {title}" for name, (_, title) in zip("ab", panels)])
    entries = ((common.GREY, "occluder"), (common.GREEN, "shadow vectors"), (common.RED, "bases of cones"))
    common.save(common.stack(picture, common.key(entries, picture.shape[1])), f"{arguments.output}/figure3.png", levels=64)


if __name__ == "__main__":
    main()
