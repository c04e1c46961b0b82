# SPDX-License-Identifier: BSD-3-Clause
"""The rooms of Data/ with their light and camera: what the examples share."""

import os

import numpy as np
import shadowcones as sc
import vtkmodules.vtkRenderingOpenGL2  # so that windows of the examples can draw
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkCamera

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


def ceiling_light():
    """A disc of radius 0.5 under the ceiling, facing down, of radiance 1 W m^-2 sr^-1 at every wavelength."""
    light = sc.vtkAreaLightSource()
    light.SetShapeToDisc()
    light.SetCenter(0.0, 5.49, 0.0)
    light.SetNormal(0.0, -1.0, 0.0)
    light.SetRadius(0.5)
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
