#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cones that are proved to hold the chair's shadow: fitted grey, grown orange, added blue; and cones of the mesh alone.

Prints how many there are of each, whether they are proved and how much of their volume is in shadow.
Needs a display."""

import common
import cone_sets
import figure7
import scenes
from vtkmodules.vtkRenderingCore import vtkRenderer

ORIGINS = {"fitted": "as fitted", "grown": "grown by the proof", "added": "added by the proof"}
LOOKS = ((0.55, 0.55, 0.55, 0.1), (0.95, 0.5, 0.05, 0.22), (0.05, 0.35, 0.9, 0.22))  # a colour and an opacity for each
TUNINGS = {"Conservative": "fitted, then proved", "Automatic": "around parts of the mesh"}


def report(name, cones, occluders, light):
    """How many cones of each origin, and what the accuracy says."""
    accuracy = cone_sets.accuracy(cones, occluders, light)
    accuracy.SetNumberOfSamples(20000)
    accuracy.Update()
    measures = cone_sets.measures(accuracy)
    proved, share = measures["Certified"][0] == 1, measures["Precision"][0]
    origins = common.array(cones.GetOutput().GetPointData(), "ConeOrigin")
    counts = ", ".join(f"{(origins == i).sum()} {origin}" for i, origin in enumerate(ORIGINS))
    choice = cones.GetOutput().GetFieldData().GetAbstractArray("TuningChoice").GetValue(0)
    print(f"{name}: {counts}; proved: {proved}; in shadow: {share:.3f} of the cones' volume\n  {choice}", flush=True)


def view(occluders, cones, size):
    """The cones, cut short, coloured by their origin."""
    geometry = cone_sets.surfaces(cones.GetOutputPort(), 0.6)
    renderer = vtkRenderer()
    common.add_actor(renderer, occluders, common.GREY, ambient=0.4)
    common.paint(renderer, geometry, "ConeOrigin", common.category_table(LOOKS), cells=True, ambient=0.5)
    camera, _ = figure7.views("chair")[1]
    camera.Zoom(1.1)
    return common.render(renderer, camera, size)


def main():
    arguments = common.parse(common.parser(__doc__, size=700, vectors=5800))
    light = scenes.ceiling_light()
    occluders = scenes.label(scenes.read(f"{arguments.data}/chair.vtp"))
    vectors = common.shadow_vectors(occluders, light, arguments.vectors)
    vectors.SetStorageToHitPoint()
    pictures = []
    for tuning in TUNINGS:
        cones = cone_sets.proved(vectors, occluders, light, tuning)
        report(tuning, cones, occluders, light)
        pictures.append(view(occluders, cones, arguments.size))
    picture = common.table([pictures], list(TUNINGS.values()))
    strip = common.key([(look[:3], words) for look, words in zip(LOOKS, ORIGINS.values())], picture.shape[1])
    common.save(common.stack(picture, strip), f"{arguments.output}/proved-cones.png", levels=40)


if __name__ == "__main__":
    main()
