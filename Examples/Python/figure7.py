#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The cones of a chair and a tree (the paper's figure 7): blue, their base discs red, the shadow vectors green."""

import os

import common
import scenes

MODELS = ("chair", "tree")
# Cones are cut here, world units from their base: the leaves' are small and many.
LENGTHS = {"chair": 0.5, "tree": 0.25}


def views(model):
    """Camera and opacity of the mesh: from behind the light, where the mesh would hide the discs, and from the side."""
    height = 3.0 if model == "chair" else 4.5
    near = common.camera_at((0.0, 8.5, 0.4), (0.0, 0.5 * height, 0.0), 27.0 if model == "chair" else 48.0, (0.0, 0.0, -1.0))
    side = common.camera_at((6.5, 0.5 * height + 1.6, 8.0), (0.0, 0.44 * height, 0.0), 13.0 + 4.0 * height, (0.0, 1.0, 0.0))
    return (near, 0.4), (side, 1.0)


def main():
    arguments = common.parse(common.parser(__doc__, size=560, vectors=5800))
    light = scenes.ceiling_light()
    rows = []
    for model in MODELS:
        occluders = scenes.label(scenes.read(os.path.join(arguments.data, model + ".vtp")))
        vectors = common.shadow_vectors(occluders, light, arguments.vectors)
        cones = common.cone_set(vectors)
        print(f"{model}: {common.summary(cones)}", flush=True)
        rows.append([common.cone_view(occluders, vectors, cones, LENGTHS[model], view, arguments.size, opacity)
                     for view, opacity in views(model)])
    picture = common.table(rows, ("from near the light", "from the side"), MODELS)
    entries = ((common.GREEN, "shadow vectors"), (common.RED, "base discs"), (common.BLUE, "cones, cut short"))
    common.save(common.stack(picture, common.key(entries, picture.shape[1])),
                os.path.join(arguments.output, "figure7.png"), levels=40)


if __name__ == "__main__":
    main()
