# SPDX-License-Identifier: BSD-3-Clause
"""Grids and volumes as pictures: maps, edges, smoke, cuts, and a window to turn them in. What the examples share."""

import common
import numpy as np
import vtkmodules.vtkInteractionStyle  # what the mouse does in the window
import vtkmodules.vtkRenderingVolumeOpenGL2  # volumes on the graphics card
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter, vtkFeatureEdges
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume, vtkVolumeProperty)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper


def colored(values, highest, bands, width, height):
    """Rows of numbers from 0 as a picture of that size, in so many bands of colour up to the highest."""
    rows, columns = np.linspace(0, values.shape[0] - 1, height), np.linspace(0, values.shape[1] - 1, width)
    values = np.array([np.interp(columns, np.arange(values.shape[1]), row) for row in values])
    values = np.array([np.interp(rows, np.arange(values.shape[0]), column) for column in values.T]).T
    return common.scale(bands)[np.clip(values / highest * bands, 0, bands - 1).astype(int)].round().astype(np.uint8)


def limit_table(limit, highest, above):
    """Greys from 0 up to a limit, lighter for more, and one colour above."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(400)
    for k in range(400):
        value = highest * (k + 0.5) / 400
        grey = 0.3 + 0.6 * min(value / limit, 1.0)
        table.SetTableValue(k, *(above if value > limit else (grey, grey, grey)), 1.0)
    table.SetTableRange(0.0, highest)
    return table


def add_edges(renderer, source):
    """The sharp edges of a mesh as dark lines."""
    edges = vtkFeatureEdges()
    edges.SetInputConnection(source.GetOutputPort())
    edges.ColoringOff()
    common.add_actor(renderer, edges, common.INK, line_width=2.0, ambient=1.0)


def add_smoke(renderer, volume):
    """The visible share of a light, 0 to 1, as dark smoke in space: what is lit is clear."""
    mapper = vtkSmartVolumeMapper()
    mapper.SetInputConnection(volume.GetOutputPort())
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0.0, 0.9)
    opacity.AddPoint(0.5, 0.25)
    opacity.AddPoint(1.0, 0.0)
    color = vtkColorTransferFunction()
    color.AddRGBPoint(0.0, 0.05, 0.07, 0.25)
    color.AddRGBPoint(1.0, 0.95, 0.75, 0.4)
    look = vtkVolumeProperty()
    look.SetScalarOpacity(opacity)
    look.SetScalarOpacityUnitDistance(0.5)
    look.SetColor(color)
    look.SetInterpolationTypeToLinear()
    smoke = vtkVolume()
    smoke.SetMapper(mapper)
    smoke.SetProperty(look)
    renderer.AddVolume(smoke)


def add_cut(renderer, volume, name, table, origin, normal):
    """A plane through a volume, coloured by a point array."""
    plane = vtkPlane()
    plane.SetOrigin(*origin)
    plane.SetNormal(*normal)
    cut = vtkCutter()
    cut.SetCutFunction(plane)
    cut.SetInputConnection(volume.GetOutputPort())
    common.paint(renderer, cut, name, table)


def show_in_window(renderer, camera, size, title):
    """What a renderer shows, to be turned with the mouse, until the window is closed."""
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetActiveCamera(camera)
    window = vtkRenderWindow()
    window.SetSize(size, size)
    window.SetWindowName(title)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    window.Render()
    interactor.Start()
