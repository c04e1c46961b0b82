#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How far to trust the cones of chair and tree: a slice of the truth, the cones' errors there, the worst cones."""

import common
import cone_sets
import numpy as np
import scenes

# The plane z = ... of the slice: behind the back of the chair, through the middle of the tree.
MODELS = {"chair": -1.15, "tree": 0.0}
# A colour for true negatives, true positives, false positives and false negatives.
COLORS = ((1.0, 1.0, 1.0), (0.6, 0.6, 0.62), common.SKY_BLUE, common.VERMILION)
MEANING = ("lit, outside all cones", "shadow, in a cone", "lit, but in a cone", "shadow outside all cones")


def slices(accuracy, grid, size):
    """The truth and the confusion classes of a slice, as pictures."""
    accuracy.SetInputData(grid)
    accuracy.SetNumberOfLightSamples(144)
    accuracy.Update()
    samples = accuracy.GetOutput().GetPointData()
    truth = np.repeat(common.array(samples, "Truth").reshape(size, size, 1), 3, axis=2)
    colors = np.round(255 * np.array(COLORS)).astype(np.uint8)
    return [(40 + 215 * truth).astype(np.uint8), colors[common.array(samples, "Confusion").reshape(size, size)]]


def row(title, occluders, light, cones, z, precision, size):
    """The pictures of a cone set: truth and errors in the slice, and the cones coloured by their precision."""
    accuracy = cone_sets.accuracy(cones, occluders, light)
    accuracy.Update()
    print(f"{title}: {common.summary(cones)}")
    for quantity, (value, low, high) in cone_sets.measures(accuracy).items():
        print(f"  {quantity:<16}{value:9.4f}  ({low:.4f} to {high:.4f})")
    by_cone = cone_sets.cones_by_precision(accuracy, occluders, precision, size)
    return slices(accuracy, scenes.slice_of_room(occluders.GetOutput(), z, size), size) + [by_cone]


def main():
    arguments = common.parse(common.parser(__doc__, size=460, vectors=5800))
    light, precision = scenes.ceiling_light(), common.color_table(0.5, 1.0, bands=10)
    for model, z in MODELS.items():
        occluders = scenes.label(scenes.read(f"{arguments.data}/{model}.vtp"))
        rows = []
        for kind, cones_of in (("bounds", cone_sets.bounds), ("paper", common.cone_set)):
            cones = cones_of(common.shadow_vectors(occluders, light, arguments.vectors))
            rows.append(row(f"{model}, {kind}", occluders, light, cones, z, precision, arguments.size))
        picture = common.table(rows, ("truth", "what the cones say", "cone by cone"), ("bounds", "paper"))
        width = picture.shape[1]
        classes = common.key(list(zip(COLORS, MEANING)), width)
        words = "Cone by cone: share of the cone's volume that is in shadow"
        shares = common.legend(precision, words, width, 6, "{:.1f}")
        common.save(common.stack(picture, classes, shares), f"{arguments.output}/accuracy-{model}.png", levels=32)


if __name__ == "__main__":
    main()
