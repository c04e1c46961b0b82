# SPDX-License-Identifier: BSD-3-Clause
"""The rooms of Data/ with their light and camera, and other scenes: what the examples share."""

import math
import os

import numpy as np
import shadowcones as sc
import vtkmodules.vtkRenderingOpenGL2  # so that windows of the examples can draw
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkCompositeDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPolyData)
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataReader
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


def ball(place, radius, fine):
    """A sphere; `fine` is the number of its meridians; half as many circles."""
    sphere = vtkSphereSource()
    sphere.SetCenter(*place)
    sphere.SetRadius(radius)
    sphere.SetThetaResolution(fine)
    sphere.SetPhiResolution(fine // 2)
    return sphere


def house():
    """A box of ten by ten, twenty high."""
    cube = vtkCubeSource()
    cube.SetBounds(0.0, 10.0, 0.0, 20.0, 0.0, 10.0)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(cube.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


def ring(corners=96):
    """A flat ring half way under the ceiling light."""
    points, faces = vtkPoints(), vtkCellArray()
    for k in range(corners):
        angle = 2.0 * math.pi * k / corners
        for radius in (0.5, 1.2):
            points.InsertNextPoint(radius * math.cos(angle), 2.6, radius * math.sin(angle))
        a, b = 2 * k, 2 * ((k + 1) % corners)
        faces.InsertNextCell(4, (a, a + 1, b + 1, b))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(faces)
    return mesh


def slice_of_room(mesh, z, size):
    """Sample points in a plane across z, `size` by `size`, from the floor to a bit above a mesh."""
    top = 1.08 * mesh.GetBounds()[3]
    step = top / size
    grid = vtkImageData()
    grid.SetDimensions(size, size, 1)
    grid.SetSpacing(step, step, 1.0)
    grid.SetOrigin(0.5 * (step - top), 0.5 * step, z)
    return grid


def smooth_noise(random, points, cells):
    """Values between -1 and 1, `points` along each axis, that vary over about 1 / `cells` of it."""
    noise = random.uniform(-1.0, 1.0, (cells + 1,) * 3)
    place = np.linspace(0.0, cells, points)
    cell = np.minimum(place.astype(int), cells - 1)
    share = place - cell
    share = share * share * (3.0 - 2.0 * share)
    for axis in range(3):
        weight = share.reshape([-1 if a == axis else 1 for a in range(3)])
        noise = (1.0 - weight) * noise.take(cell, axis) + weight * noise.take(cell + 1, axis)
    return noise


def write_vti(image, path):
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()
    print(f"wrote {path}")


def box(*bounds):
    """The six sides of a box."""
    cube = vtkCubeSource()
    cube.SetBounds(*bounds)
    cube.Update()
    return cube.GetOutput()


def solid(*bounds):
    """A box whose sides are one closed surface: normals of its own would keep them apart."""
    mesh = box(*bounds)
    mesh.GetPointData().Initialize()
    return mesh


def sheet(origin, first, second, cells):
    """A rectangle from a corner along two edges, in so many cells along each. It looks along first x second."""
    plane = vtkPlaneSource()
    plane.SetOrigin(*origin)
    plane.SetPoint1(*np.add(origin, first))
    plane.SetPoint2(*np.add(origin, second))
    plane.SetResolution(*cells)
    plane.Update()
    return plane.GetOutput()


def joined(meshes):
    """Several meshes as one."""
    append = vtkAppendPolyData()
    for mesh in meshes:
        append.AddInputData(mesh)
    append.Update()
    return append.GetOutput()


def label_by_name(meshes):
    """The occluders of a dictionary, one a mesh."""
    blocks = vtkMultiBlockDataSet()
    for number, (name, mesh) in enumerate(meshes.items()):
        blocks.SetBlock(number, mesh)
        blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)
    occluders = sc.vtkLabelOccluders()
    occluders.SetInputData(blocks)
    return occluders


def exhibits():
    """Of a small museum: two pedestals with a ball on each."""
    parts = []
    for x, y, height in ((-1.1, 0.3, 1.0), (1.2, -0.2, 0.7)):
        ball = vtkSphereSource()
        ball.SetCenter(x, y, height + 0.3)
        ball.SetRadius(0.3)
        ball.SetThetaResolution(96)
        ball.SetPhiResolution(64)
        ball.Update()
        parts += [box(x - 0.25, x + 0.25, y - 0.25, y + 0.25, 0.0, height), ball.GetOutput()]
    return joined(parts)


def museum(things, points):
    """Floor, back wall and side wall of the museum, so many points a side, and the things in it; all with normals."""
    east, north, up = (5.0, 0.0, 0.0), (0.0, 4.0, 0.0), (0.0, 0.0, 3.0)
    corner = (-2.5, -2.0, 0.0)
    sides = ((corner, east, north), ((-2.5, 2.0, 0.0), east, up), (corner, north, up))
    triangles = vtkTriangleFilter()
    triangles.SetInputData(things)
    fine = vtkLinearSubdivisionFilter()
    fine.SetInputConnection(triangles.GetOutputPort())
    fine.SetNumberOfSubdivisions(2)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(fine.GetOutputPort())
    normals.ConsistencyOff()
    normals.Update()
    return joined([sheet(*side, (points - 1, points - 1)) for side in sides] + [normals.GetOutput()])


def shining_tube(place, length, radius, power):
    """A tube along y that shines so many watts outward from its skin: power = pi x area x radiance."""
    sides = 16
    skin = vtkCylinderSource()
    skin.SetCenter(*place)
    skin.SetHeight(length)
    skin.SetRadius(radius)
    skin.SetResolution(sides)
    skin.CappingOff()
    skin.Update()
    area = 2 * sides * radius * np.sin(np.pi / sides) * length
    spectrum = numpy_to_vtk(np.array([power / (np.pi * area)]), deep=True)
    spectrum.SetName("LightSpectrum")
    skin.GetOutput().GetFieldData().AddArray(spectrum)
    return skin.GetOutput()


# Metres: x is east, y is north. Around a yard of 24 by 16.
COURTYARD = {
    "north wing": (-18.0, 18.0, 8.0, 16.0, 0.0, 12.0),
    "east wing": (12.0, 18.0, -8.0, 8.0, 0.0, 9.0),
    "west wing": (-18.0, -12.0, -8.0, 8.0, 0.0, 9.0),
    "south wing": (-18.0, 18.0, -14.0, -8.0, 0.0, 5.0),
    "tower": (-11.0, -5.0, -20.0, -14.0, 0.0, 24.0),
}


def sun_of_day(date, step):
    """The Sun's path over the courtyard, in Munich, from midnight to midnight UTC, in steps of minutes."""
    path = sc.vtkSunPath()
    path.SetLatitude(48.14)
    path.SetLongitude(11.58)
    path.SetStart(date + "T00:00:00Z")
    path.SetEnd(date + "T24:00:00Z")
    path.SetStep(step)
    return path


def courtyard():
    """The houses around the yard, an occluder each."""
    return label_by_name({name: box(*bounds) for name, bounds in COURTYARD.items()})


def courtyard_surfaces(size):
    """The ground, and the roofs and walls of the houses around the yard, in cells of about that size."""
    parts = [((-26, -26, 0), (52, 0, 0), (0, 50, 0))]
    for x0, x1, y0, y1, z0, z1 in COURTYARD.values():
        x, y, z = (x1 - x0, 0, 0), (0, y1 - y0, 0), (0, 0, z1 - z0)
        parts += [((x0, y0, z1), x, y), ((x0, y0, z0), x, z), ((x0, y1, z0), x, z),
                  ((x0, y0, z0), y, z), ((x1, y0, z0), y, z)]
    return joined([sheet(*part, [max(1, round(np.linalg.norm(edge) / size)) for edge in part[1:]]) for part in parts])


def l_plate(height=1.5):
    """A plate like an L without thickness, two wide, level; its arms are 0.7 wide."""
    corners = ((-1.0, -1.0), (-0.3, -1.0), (1.0, -1.0), (-1.0, -0.3), (-0.3, -0.3), (1.0, -0.3), (-1.0, 1.0), (-0.3, 1.0))
    points, faces, mesh = vtkPoints(), vtkCellArray(), vtkPolyData()
    for x, z in corners:
        points.InsertNextPoint(x, height, z)
    for face in ((0, 3, 4, 1), (1, 4, 5, 2), (3, 6, 7, 4)):
        faces.InsertNextCell(4, face)
    mesh.SetPoints(points)
    mesh.SetPolys(faces)
    return mesh
