# SPDX-License-Identifier: BSD-3-Clause
"""The rooms of Data/ with their light and camera, and a window to show cones in: what the examples share."""

import os

import numpy as np
import shadowcones as sc
import vtkmodules.vtkRenderingOpenGL2  # the renderers that the window below needs
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkHedgeHog
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCamera, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter)

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")
MEDIUM_BOUNDS = (-2.75, 2.75, 0.0, 5.2, -2.75, 2.75)


def read(path):
    """The mesh of a .vtp file."""
    if not os.path.exists(path):
        raise SystemExit(f"There is no file {path}; --data names the folder of the meshes")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def ceiling_light(radiance=120.0):
    """A disc of radius 0.5 under the ceiling, facing down. Radiance in W m^-2 sr^-1 at every wavelength."""
    light = sc.vtkAreaLightSource()
    light.SetShapeToDisc()
    light.SetCenter(0.0, 5.49, 0.0)
    light.SetNormal(0.0, -1.0, 0.0)
    light.SetRadius(0.5)
    light.SetRadiance(radiance)
    return light


def set_reflectance(mesh, value):
    """Give every cell the same diffuse reflectance at all seven wavelengths."""
    array = numpy_to_vtk(np.full((mesh.GetNumberOfCells(), 7), value, dtype=np.float32), deep=True)
    array.SetName("Reflectance")
    mesh.GetCellData().AddArray(array)


def label(mesh, reflectance=0.6):
    """The occluders of a mesh, one id a piece."""
    set_reflectance(mesh, reflectance)
    occluders = sc.vtkLabelOccluders()
    occluders.SetInputData(mesh)
    return occluders


def put_in_room(occluders, data=DATA):
    """Occluders and the walls around them. Walls have the id -1: they catch shadows and cast none."""
    # Appending keeps the arrays that both have: "OccluderId" and "Reflectance".
    room = vtkAppendPolyData()
    room.AddInputConnection(occluders.GetOutputPort())
    room.AddInputData(read(os.path.join(data, "cornell-box.vtp")))
    return room


def front_camera():
    """From the open front of the room, which fills the image."""
    camera = vtkCamera()
    camera.SetPosition(0.0, 2.75, 12.5)
    camera.SetFocalPoint(0.0, 2.75, 0.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    camera.SetViewAngle(32.0)
    return camera


def write_png(image, path):
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def add_actor(renderer, port, color, opacity=1.0, line_width=1.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(port)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetOpacity(opacity)
    actor.GetProperty().SetLineWidth(line_width)
    renderer.AddActor(actor)


def show_cones(occluders, light, vectors, cones, length, camera, path, size=(900, 900)):
    """Draw cones in blue, cut at a length; base discs in red; shadow vectors in green. Needs a display."""
    geometry = sc.vtkConeSetGeometry()
    geometry.SetInputConnection(cones.GetOutputPort())
    geometry.SetLength(length)

    vectors.Update()
    directed = vectors.GetOutput().NewInstance()
    directed.ShallowCopy(vectors.GetOutput())
    directed.GetPointData().SetActiveVectors("Direction")
    arrows = vtkHedgeHog()
    arrows.SetInputData(directed)
    arrows.SetScaleFactor(0.08)

    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetActiveCamera(camera)
    renderer.SetUseDepthPeeling(True)
    add_actor(renderer, occluders.GetOutputPort(), (0.75, 0.72, 0.66), opacity=0.5)
    add_actor(renderer, light.GetOutputPort(), (1.0, 0.85, 0.3))
    add_actor(renderer, geometry.GetOutputPort(0), (0.15, 0.35, 0.95), opacity=0.08)
    add_actor(renderer, geometry.GetOutputPort(1), (0.9, 0.1, 0.1), opacity=0.8)
    add_actor(renderer, arrows.GetOutputPort(), (0.0, 0.6, 0.1))

    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetAlphaBitPlanes(True)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    window.Render()

    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    write_png(grab.GetOutput(), path)
