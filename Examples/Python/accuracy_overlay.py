#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How far to trust the cones of chair and tree: a slice of the truth, the cones' errors there, the worst cones."""

import os

import common
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

# The plane z = ... of the slice: behind the back of the chair, through the middle of the tree.
MODELS = {"chair": -1.15, "tree": 0.0}
# A colour for true negatives, true positives, false positives and false negatives.
COLORS = np.round(255 * np.array([(1.0, 1.0, 1.0), (0.6, 0.6, 0.62), common.SKY_BLUE, common.VERMILION])).astype(np.uint8)
MEANING = ("lit, outside all cones", "shadow, in a cone", "lit, but in a cone", "shadow outside all cones")


def bounds(vectors, cones):
    """Few, large cones that hold the shadow."""
    vectors.SetStorageToHitPoint()
    cones.OverlapOn()
    cones.CosineCorrectionOff()
    cones.SetVarianceThreshold(1.8)
    cones.SetExpansionToLightGeometry()


def paper(vectors, cones):
    """The paper's parameters, as SetToPaper() gives them."""


def slice_of_room(mesh, z, size):
    """Sample points in a plane, one a pixel, from the floor to a bit above the mesh."""
    top = 1.08 * mesh.GetBounds()[3]
    step = top / size
    grid = vtkImageData()
    grid.SetDimensions(size, size, 1)
    grid.SetSpacing(step, step, 1.0)
    grid.SetOrigin(0.5 * (step - top), 0.5 * step, z)
    return grid


def accuracy_of(cones, occluders, light):
    accuracy = sc.vtkConeSetAccuracy()
    accuracy.SetConeSetConnection(cones.GetOutputPort())
    accuracy.SetMeshConnection(occluders.GetOutputPort())
    accuracy.SetLightConnection(light.GetOutputPort())
    accuracy.SetBounds(*scenes.MEDIUM_BOUNDS)
    return accuracy


def report(name, accuracy):
    table = accuracy.GetOutputDataObject(1)
    print(name)
    for row in range(table.GetNumberOfRows()):
        quantity, value, low, high = (table.GetValue(row, column) for column in range(4))
        print(f"  {quantity.ToString():<16}{value.ToDouble():9.4f}  ({low.ToDouble():.4f} to {high.ToDouble():.4f})")


def slices(accuracy, grid, size):
    """The truth and the confusion classes of a slice, as pictures."""
    accuracy.SetInputData(grid)
    accuracy.SetNumberOfLightSamples(144)
    accuracy.Update()
    samples = accuracy.GetOutput().GetPointData()
    truth = np.repeat(common.array(samples, "Truth").reshape(size, size, 1), 3, axis=2)
    classes = common.array(samples, "Confusion").reshape(size, size)
    return [(40 + 215 * truth).astype(np.uint8), COLORS[classes]]


def cones_by_precision(accuracy, occluders, colors, size):
    geometry = sc.vtkConeSetGeometry()
    geometry.SetInputConnection(accuracy.GetOutputPort(4))
    geometry.SetLength(1.0)
    renderer = vtkRenderer()
    common.add_actor(renderer, occluders.GetOutputPort(), common.GREY, ambient=0.4)
    for port, opacity in ((0, 0.08), (1, 0.6)):
        mapper = common.add_actor(renderer, geometry.GetOutputPort(port), common.GREY, opacity, ambient=0.6).GetMapper()
        mapper.ScalarVisibilityOn()
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray("Precision")
        mapper.SetLookupTable(colors)
        mapper.UseLookupTableScalarRangeOn()
    camera = vtkCamera()
    camera.SetPosition(5.0, 2.4, 9.0)
    camera.SetViewAngle(26.0)
    renderer.SetActiveCamera(camera)
    occluders.Update()
    renderer.ResetCamera(occluders.GetOutput().GetBounds())
    camera.Zoom(1.15)
    return common.render(renderer, camera, size)


def main():
    options = common.parser(__doc__, size=460, vectors=5800)
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    precision = common.color_table(0.5, 1.0, bands=10)
    for model, z in MODELS.items():
        occluders = scenes.label(scenes.read(os.path.join(arguments.data, model + ".vtp")))
        rows = []
        for choose in (bounds, paper):
            vectors = common.shadow_vectors(occluders, light, arguments.vectors)
            cones = common.cone_set(vectors)
            choose(vectors, cones)
            accuracy = accuracy_of(cones, occluders, light)
            accuracy.Update()
            report(f"{model}, {choose.__name__}: {common.summary(cones)}", accuracy)
            by_cone = cones_by_precision(accuracy, occluders, precision, arguments.size)
            grid = slice_of_room(occluders.GetOutput(), z, arguments.size)
            rows.append(slices(accuracy, grid, arguments.size) + [by_cone])
        picture = common.table(rows, ("truth", "what the cones say", "cone by cone"), ("bounds", "paper"))
        width = picture.shape[1]
        strips = (common.key([(color / 255.0, words) for color, words in zip(COLORS, MEANING)], width),
                  common.legend(precision, "Cone by cone: share of the cone's volume that is in shadow", width, 6, "{:.1f}"))
        common.save(common.stack(picture, *strips), os.path.join(arguments.output, f"accuracy-{model}.png"), levels=32)


if __name__ == "__main__":
    main()
