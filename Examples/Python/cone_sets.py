# SPDX-License-Identifier: BSD-3-Clause
"""Cone sets that hold the shadow, and how far to trust cones: what the examples about accuracy share."""

import common
import scenes
import shadowcones as sc
from vtkmodules.vtkRenderingCore import vtkRenderer


def bounds(vectors):
    """Few, large cones that hold the shadow. Sets how the vectors are kept, too."""
    vectors.SetStorageToHitPoint()
    cones = common.cone_set(vectors)
    cones.OverlapOn()
    cones.CosineCorrectionOff()
    cones.SetVarianceThreshold(1.8)
    cones.SetExpansionToLightGeometry()
    return cones


def proved(vectors, occluders, light, tuning="Automatic"):
    """Cones that hold all of the shadow; the tuning says how they are found."""
    cones = common.cones_tuned(vectors, tuning)
    cones.SetMeshConnection(occluders.GetOutputPort())
    cones.SetLightConnection(light.GetOutputPort())
    cones.Update()
    return cones


def accuracy(cones, occluders, light):
    """The filter that compares cones with the truth in the room; there is no answer before its Update()."""
    found = sc.vtkConeSetAccuracy()
    found.SetConeSetConnection(cones.GetOutputPort())
    found.SetMeshConnection(occluders.GetOutputPort())
    found.SetLightConnection(light.GetOutputPort())
    found.SetBounds(*scenes.MEDIUM_BOUNDS)
    return found


def measures(found):
    """What an accuracy says: the value of each quantity by its name, and the ends of its interval."""
    table = found.GetOutputDataObject(1)
    return {table.GetValue(row, 0).ToString(): [table.GetValue(row, column).ToDouble() for column in (1, 2, 3)]
            for row in range(table.GetNumberOfRows())}


def surfaces(port, length):
    """Cones of an output port, cut at a length, and their base discs, to be drawn."""
    geometry = sc.vtkConeSetGeometry()
    geometry.SetInputConnection(port)
    geometry.SetLength(length)
    return geometry


def cones_by_precision(found, occluders, colors, size):
    """The worst cones of an accuracy, coloured by the share of their volume that is in shadow. Needs a display."""
    geometry = surfaces(found.GetOutputPort(4), 1.0)
    renderer = vtkRenderer()
    common.add_actor(renderer, occluders, common.GREY, ambient=0.4)
    for port, opacity in ((0, 0.08), (1, 0.6)):
        worst = geometry.GetOutputPort(port)
        common.paint(renderer, worst, "Precision", colors, cells=True, ambient=0.6, opacity=opacity)
    camera = common.camera_at((5.0, 2.4, 9.0), (0.0, 0.0, 0.0), 26.0, (0.0, 1.0, 0.0))
    renderer.SetActiveCamera(camera)
    occluders.Update()
    renderer.ResetCamera(occluders.GetOutput().GetBounds())
    camera.Zoom(1.15)
    return common.render(renderer, camera, size)
