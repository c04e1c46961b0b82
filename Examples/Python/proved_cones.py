#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cones that are proved to hold the chair's shadow: fitted grey, grown orange, added blue; and cones of the mesh alone.

Prints how many there are of each, whether the independent check finds the set proved, and how much of the cones' volume is
in shadow. Drawing needs a display."""

import os

import common
import figure7
import scenes
import shadowcones as sc
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import vtkRenderer

ORIGINS = ("fitted", "grown", "added")
# A colour and an opacity for each.
LOOKS = ((0.55, 0.55, 0.55, 0.10), (0.95, 0.50, 0.05, 0.22), (0.05, 0.35, 0.90, 0.22))
TUNINGS = ("Conservative", "Automatic")


def proved_set(occluders, light, vectors, tuning):
    cones = sc.vtkConeSetFilter()
    cones.SetInputConnection(vectors.GetOutputPort(0))
    cones.SetPhotonPathConnection(vectors.GetOutputPort(1))
    cones.SetMeshConnection(occluders.GetOutputPort())
    cones.SetLightConnection(light.GetOutputPort())
    getattr(cones, "SetTuningTo" + tuning)()
    cones.Update()
    return cones


def report(name, cones, occluders, light):
    """How many cones of each origin, and what the accuracy says."""
    accuracy = sc.vtkConeSetAccuracy()
    accuracy.SetConeSetConnection(cones.GetOutputPort())
    accuracy.SetMeshConnection(occluders.GetOutputPort())
    accuracy.SetLightConnection(light.GetOutputPort())
    accuracy.SetBounds(*scenes.MEDIUM_BOUNDS)
    accuracy.SetNumberOfSamples(20000)
    accuracy.Update()
    table = accuracy.GetOutputDataObject(1)
    values = {table.GetValue(row, 0).ToString(): table.GetValue(row, 1).ToDouble() for row in range(table.GetNumberOfRows())}
    origins = common.array(cones.GetOutput().GetPointData(), "ConeOrigin")
    counts = ", ".join(f"{(origins == i).sum()} {origin}" for i, origin in enumerate(ORIGINS))
    print(f"{name}: {counts}; proved: {values['Certified'] == 1}; in shadow: {values['Precision']:.3f} of the cones' volume")
    print("  " + cones.GetOutput().GetFieldData().GetAbstractArray("TuningChoice").GetValue(0), flush=True)


def view(occluders, cones, size):
    """The cones, cut short, coloured by their origin."""
    geometry = sc.vtkConeSetGeometry()
    geometry.SetInputConnection(cones.GetOutputPort())
    geometry.SetLength(0.6)
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(len(LOOKS))
    colors.SetTableRange(-0.5, len(LOOKS) - 0.5)
    for i, look in enumerate(LOOKS):
        colors.SetTableValue(i, *look)
    renderer = vtkRenderer()
    common.add_actor(renderer, occluders.GetOutputPort(), common.GREY, ambient=0.4)
    mapper = common.add_actor(renderer, geometry.GetOutputPort(0), common.BLUE, ambient=0.5).GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("ConeOrigin")
    mapper.SetLookupTable(colors)
    mapper.UseLookupTableScalarRangeOn()
    camera, _ = figure7.views("chair")[1]
    camera.Zoom(1.1)
    return common.render(renderer, camera, size)


def main():
    arguments = common.parse(common.parser(__doc__, size=700, vectors=5800))
    light = scenes.ceiling_light()
    occluders = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))
    vectors = common.shadow_vectors(occluders, light, arguments.vectors)
    vectors.SetStorageToHitPoint()
    pictures = []
    for tuning in TUNINGS:
        cones = proved_set(occluders, light, vectors, tuning)
        report(tuning, cones, occluders, light)
        pictures.append(view(occluders, cones, arguments.size))
    picture = common.table([pictures], ["fitted, then proved", "around parts of the mesh"])
    strip = common.key([(look[:3], words) for look, words in zip(LOOKS, ("as fitted", "grown by the proof", "added by the proof"))],
                       picture.shape[1])
    common.save(common.stack(picture, strip), os.path.join(arguments.output, "proved-cones.png"), levels=40)


if __name__ == "__main__":
    main()
