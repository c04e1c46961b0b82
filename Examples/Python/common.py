# SPDX-License-Identifier: BSD-3-Clause
"""Command line, meshes, the chain of filters with the paper's parameters, and pictures: what the examples share."""

import argparse
import functools
import os

import numpy as np
import scenes
import shadowcones as sc
import vtkmodules.vtkRenderingFreeType  # the text of captions
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData, vtkHedgeHog
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImport import vtk3DSImporter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextProperty, vtkTextRenderer, vtkWindowToImageFilter)

# Debian's package glmark2-data: real meshes that nobody here made.
REAL_MESHES = "/usr/share/glmark2/models"

GREY = (0.8, 0.78, 0.74)
BLUE = (0.15, 0.35, 0.95)
RED = (0.9, 0.1, 0.1)
GREEN = (0.0, 0.55, 0.1)
# From blue through grey to yellow, lighter all the way: the colours of "cividis", which colour-blind people see alike.
SCALE = np.array([(0, 34, 78), (18, 53, 112), (59, 73, 108), (87, 93, 109), (112, 113, 115), (138, 134, 120), (165, 156, 116),
                  (195, 179, 105), (225, 204, 85), (254, 232, 56)])


def parser(description, size, vectors=None):
    """A parser with the options of every example, for more to be added."""
    result = argparse.ArgumentParser(description=description)
    result.add_argument("--output", default="output", help="folder to write to (default: output)")
    result.add_argument("--data", default=scenes.DATA, help="folder of the meshes (default: Data of this project)")
    result.add_argument("--size", type=int, default=size,
                        help=f"width and height of a picture in pixels (default: {size})")
    if vectors:
        result.add_argument("--vectors", type=int, default=vectors,
                            help=f"number of shadow vectors (default: {vectors})")
    return result


def parse(options):
    """The command line; the folder to write to is there afterwards."""
    arguments = options.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    return arguments


def array(data, name):
    """A named array of point, cell or field data as numpy sees it."""
    return vtk_to_numpy(data.GetArray(name))


# Meshes


def read_3ds(path):
    """All objects of a .3ds file as one mesh."""
    importer = vtk3DSImporter()
    importer.SetFileName(path)
    importer.ComputeNormalsOff()
    importer.Update()
    append = vtkAppendPolyData()
    actors = importer.GetRenderer().GetActors()
    actors.InitTraversal()
    for _ in range(actors.GetNumberOfItems()):
        mapper = actors.GetNextActor().GetMapper()
        mapper.Update()
        append.AddInputData(mapper.GetInput())
    # The importer splits points where the smoothing changes.
    clean = vtkCleanPolyData()
    clean.SetInputConnection(append.GetOutputPort())
    clean.Update()
    return clean.GetOutput()


def read_mesh(path):
    """A mesh from a .vtp, .obj, .ply, .stl or .3ds file."""
    readers = {".vtp": vtkXMLPolyDataReader, ".obj": vtkOBJReader, ".ply": vtkPLYReader, ".stl": vtkSTLReader}
    extension = os.path.splitext(path)[1].lower()
    if not os.path.exists(path):
        raise SystemExit(f"There is no file {path}")
    if extension == ".3ds":
        mesh = read_3ds(path)
    elif extension in readers:
        reader = readers[extension]()
        reader.SetFileName(path)
        reader.Update()
        mesh = reader.GetOutput()
    else:
        raise SystemExit(f"{path}: none of {', '.join(readers)}, .3ds")
    if mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0:
        raise SystemExit(f"{path}: there are no polygons")
    return mesh


def stand_in_room(path, size):
    """A mesh file, `size` across at its widest, centred on the floor. Meshes of this project stay where they are."""
    mesh = read_mesh(path)
    if os.path.dirname(os.path.realpath(path)) == os.path.realpath(scenes.DATA):
        return mesh
    low, high = np.reshape(mesh.GetBounds(), (3, 2)).T
    scale = size / max(high - low)
    transform = vtkTransform()
    transform.Scale(scale, scale, scale)
    transform.Translate(-0.5 * (low[0] + high[0]), -low[1], -0.5 * (low[2] + high[2]))
    move = vtkTransformPolyDataFilter()
    move.SetInputData(mesh)
    move.SetTransform(transform)
    move.Update()
    return move.GetOutput()


def receivers(mesh):
    """Mark a mesh to catch shadows and cast none."""
    ids = numpy_to_vtk(np.full(mesh.GetNumberOfCells(), -1, dtype=np.int32), deep=True)
    ids.SetName("OccluderId")
    mesh.GetCellData().AddArray(ids)
    return mesh


# The chain


def shadow_vectors(occluders, light, number):
    """Shadow vectors of labelled occluders, on their back sides as in the paper."""
    vectors = sc.vtkShadowVectorFilter()
    vectors.SetToPaper()
    vectors.SetInputConnection(occluders.GetOutputPort())
    vectors.SetLightConnection(light.GetOutputPort())
    vectors.SetTargetNumberOfVectors(number)
    vectors.SetSeed(1)
    return vectors


def cone_set(vectors):
    """Cones of shadow vectors, as the paper makes them."""
    cones = sc.vtkConeSetFilter()
    cones.SetToPaper()
    cones.SetInputConnection(vectors.GetOutputPort(0))
    cones.SetPhotonPathConnection(vectors.GetOutputPort(1))
    return cones


def light_shafts(room, light, cones, mode, size):
    """The paper's fog in the room, as its open front shows it. `mode` is one of the six of the image; cones may be None."""
    image = sc.vtkScatteringImageFilter()
    image.SetInputConnection(room.GetOutputPort())
    image.SetLightConnection(light.GetOutputPort())
    if cones:
        image.SetConeSetConnection(cones.GetOutputPort())
    image.SetCamera(scenes.front_camera())
    image.SetResolution(size, size)
    getattr(image, "SetModeTo" + mode)()
    image.SetSigmaS(0.12)
    image.SetPhasePresetToRayleigh()
    image.SetMediumBounds(*scenes.MEDIUM_BOUNDS)
    return image


def summary(cones):
    """One line on a cone set."""
    cones.Update()
    field = cones.GetOutput().GetFieldData()
    return (f"{field.GetArray('NumberOfVectors').GetTuple1(0):,.0f} vectors, "
            f"{cones.GetOutput().GetNumberOfPoints()} cones, "
            f"{field.GetArray('DiscardedFraction').GetTuple1(0):.1%} of the vectors discarded")


# Pictures: numpy arrays of height x width x 3 bytes, the lowest row first as VTK has it


def pixels(image):
    """The active scalars of a 2-D image as a picture."""
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3]


def save(picture, path, levels=256):
    """Write a picture as PNG. Fewer levels a channel make a smaller file; 32 are enough for drawings."""
    picture = np.round(np.round(picture * ((levels - 1) / 255.0)) * (255.0 / (levels - 1))).astype(np.uint8)
    height, width, _ = picture.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(picture).reshape(-1, 3), deep=True))
    scenes.write_png(image, path)
    print(f"wrote {path}")


def text(words, width, height):
    """Dark words in the middle of a white strip."""
    style = vtkTextProperty()
    style.SetFontSize(max(6, round(0.58 * height)))
    style.SetColor(1.0, 1.0, 1.0)
    rendered = vtkImageData()
    strip = np.full((height, width, 3), 255, dtype=np.uint8)
    if words and vtkTextRenderer.GetInstance().RenderString(style, words, rendered, [0, 0], 72):
        columns, rows, _ = rendered.GetDimensions()
        ink = vtk_to_numpy(rendered.GetPointData().GetScalars()).reshape(rows, columns, -1)[:, :, -1]
        inked_rows, inked_columns = np.flatnonzero(ink.any(axis=1)), np.flatnonzero(ink.any(axis=0))
        ink = ink[inked_rows[0]:inked_rows[-1] + 1, inked_columns[0]:inked_columns[-1] + 1][:height, :width]
        y, x = (height - ink.shape[0]) // 2, (width - ink.shape[1]) // 2
        strip[y:y + ink.shape[0], x:x + ink.shape[1]] = 255 - (ink * 0.85).astype(np.uint8)[:, :, np.newaxis]
    return strip


def table(rows, columns, row_titles=None, gap=4):
    """Pictures of one size in rows, under the titles of their columns and beside those of their rows."""
    height, width, _ = rows[0][0].shape
    line = 26

    def beside(pictures, first):
        between = np.full((pictures[0].shape[0], gap, 3), 255, dtype=np.uint8)
        parts = [part for picture in pictures for part in (between, picture)][1:]
        return np.concatenate(([first] if row_titles else []) + parts, axis=1)

    lines = [beside([text(title, width, line) for title in columns], text("", line, line))]
    for index, pictures in enumerate(rows):
        title = np.rot90(text(row_titles[index], height, line), -1) if row_titles else None
        lines += [beside(pictures, title)]
    between = np.full((gap, lines[0].shape[1], 3), 255, dtype=np.uint8)
    return np.concatenate([part for strip in reversed(lines) for part in (strip, between)][:-1], axis=0)


def scale(count):
    """So many colours from the first to the last, 0 to 255."""
    at = np.linspace(0.0, len(SCALE) - 1.0, count)
    return np.stack([np.interp(at, np.arange(len(SCALE)), SCALE[:, channel]) for channel in range(3)], axis=1)


def color_by(actor, name, most):
    """Colour the cells of a mesh by their values of an array, from 0 to most."""
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(256)
    colors.SetTableRange(0.0, most)
    for k, color in enumerate(scale(256)):
        colors.SetTableValue(k, *(color / 255.0))
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(name)
    mapper.UseLookupTableScalarRangeOn()
    mapper.SetLookupTable(colors)


def legend(width, height, values, form):
    """A strip of the scale with values under it, the first at its beginning and the last at its end."""
    line, label = 26, 60
    margin = max(width // 4, label // 2)
    bar = np.full((height + line, width, 3), 255, dtype=np.uint8)
    bar[line:, margin:width - margin] = scale(width - 2 * margin).astype(np.uint8)
    for value in values:
        at = margin + round((width - 2 * margin) * (value - values[0]) / (values[-1] - values[0])) - label // 2
        bar[:line, at:at + label] = text(form.format(value), label, line)
    return bar


def add_actor(renderer, source, color, opacity=1.0, line_width=1.0, ambient=0.0):
    """Show a mesh or the output of a filter. `ambient` is the share of light that does not come from the camera."""
    mapper = vtkPolyDataMapper()
    if isinstance(source, vtkPolyData):
        mapper.SetInputData(source)
    else:
        mapper.SetInputConnection(source)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*color)
    look.SetOpacity(opacity)
    look.SetLineWidth(line_width)
    look.SetAmbient(ambient)
    look.SetDiffuse(1.0 - ambient)
    renderer.AddActor(actor)
    return actor


@functools.lru_cache(maxsize=None)
def off_screen_window():
    """One window for all pictures: a virtual display may shut down when its only window closes."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetAlphaBitPlanes(True)
    window.SetMultiSamples(0)
    return window


def render(renderer, camera, size):
    """What a renderer shows off screen, as a picture. Needs a display."""
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetActiveCamera(camera)
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(40)
    renderer.ResetCameraClippingRange()
    window = off_screen_window()
    window.SetSize(2 * size, 2 * size)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    window.RemoveRenderer(renderer)
    # Four pixels to one: depth peeling has no multi-sampling.
    large = pixels(grab.GetOutput()).reshape(size, 2, size, 2, 3)
    return large.mean(axis=(1, 3)).round().astype(np.uint8)


def cone_view(occluders, vectors, cones, length, camera, size, mesh_opacity=1.0):
    """Cones in blue, cut at a length; base discs in red; shadow vectors in green; the mesh in grey. Needs a display."""
    geometry = sc.vtkConeSetGeometry()
    geometry.SetInputConnection(cones.GetOutputPort())
    geometry.SetLength(length)
    vectors.Update()
    directed = vectors.GetOutput().NewInstance()
    directed.ShallowCopy(vectors.GetOutput())
    directed.GetPointData().SetActiveVectors("Direction")
    lines = vtkHedgeHog()
    lines.SetInputData(directed)
    lines.SetScaleFactor(0.06)

    renderer = vtkRenderer()
    add_actor(renderer, occluders.GetOutputPort(), GREY, opacity=mesh_opacity, ambient=0.4)
    add_actor(renderer, geometry.GetOutputPort(0), BLUE, opacity=0.08, ambient=0.5)
    add_actor(renderer, geometry.GetOutputPort(1), RED, opacity=0.6, ambient=1.0)
    add_actor(renderer, lines.GetOutputPort(), GREEN, line_width=2.0, ambient=1.0)
    return render(renderer, camera, size)
