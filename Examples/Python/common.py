# SPDX-License-Identifier: BSD-3-Clause
"""Command line, meshes, the chain of filters with the paper's parameters, pictures and their legends: what the examples share."""

import argparse
import functools
import os
import struct
import zlib

import numpy as np
import scenes
import shadowcones as sc
import vtkmodules.vtkRenderingFreeType  # the text of captions
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCellCenters, vtkCleanPolyData, vtkHedgeHog
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImport import vtk3DSImporter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkBillboardTextActor3D, vtkCamera, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextProperty,
    vtkTextRenderer, vtkWindowToImageFilter)

# Debian's package glmark2-data: real meshes that nobody here made.
REAL_MESHES = "/usr/share/glmark2/models"

GREY = (0.8, 0.78, 0.74)
INK = (0.1, 0.1, 0.1)
BLUE = (0.15, 0.35, 0.95)
RED = (0.9, 0.1, 0.1)
GREEN = (0.0, 0.55, 0.1)
# From blue through grey to yellow, lighter all the way: the colours of "cividis", which colour-blind people see alike.
SCALE = np.array([(0, 34, 78), (18, 53, 112), (59, 73, 108), (87, 93, 109), (112, 113, 115), (138, 134, 120), (165, 156, 116),
                  (195, 179, 105), (225, 204, 85), (254, 232, 56)])
# Of Okabe and Ito: names that every eye tells apart.
ORANGE = (0.90, 0.62, 0.0)
SKY_BLUE = (0.34, 0.71, 0.91)
TEAL = (0.0, 0.62, 0.45)
YELLOW = (0.94, 0.89, 0.26)
DARK_BLUE = (0.0, 0.28, 0.53)
VERMILION = (0.84, 0.37, 0.0)
PURPLE = (0.80, 0.47, 0.65)


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


def centers(data):
    """The centres of the cells of a data set, a row each."""
    found = vtkCellCenters()
    found.SetInputData(data)
    found.Update()
    return vtk_to_numpy(found.GetOutput().GetPoints().GetData())


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


def turned(source, place, angle, axis=(1, 0, 0), scale=1.0):
    """The output of a source, scaled, turned about an axis through the origin by degrees, and then moved."""
    transform = vtkTransform()
    transform.Translate(*place)
    transform.RotateWXYZ(angle, *axis)
    transform.Scale(scale, scale, scale)
    move = vtkTransformPolyDataFilter()
    if isinstance(source, vtkPolyData):
        move.SetInputData(source)
    else:
        move.SetInputConnection(source.GetOutputPort())
    move.SetTransform(transform)
    return move


def receivers(mesh):
    """Mark a mesh to catch shadows and cast none."""
    ids = numpy_to_vtk(np.full(mesh.GetNumberOfCells(), -1, dtype=np.int32), deep=True)
    ids.SetName("OccluderId")
    mesh.GetCellData().AddArray(ids)
    return mesh


def brick(x0, x1, y0, y1, z0, z1):
    """A box as (points, faces)."""
    points = [(x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    return points, [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def painted(source, red, green, blue):
    """The output of a source, or (points, faces), with a diffuse reflectance for seven wavelengths from blue to red."""
    if isinstance(source, tuple):
        points, faces = source
        mesh = vtkPolyData()
        mesh.SetPoints(vtkPoints())
        mesh.GetPoints().SetData(numpy_to_vtk(np.array(points, dtype=float), deep=True))
        cells = vtkCellArray()
        for face in faces:
            cells.InsertNextCell(len(face), face)
        mesh.SetPolys(cells)
    else:
        source.Update()
        mesh = source.GetOutput()
    bands = np.array([blue, blue, 0.5 * (blue + green), green, 0.5 * (green + red), red, red], dtype=np.float32)
    array = numpy_to_vtk(np.tile(bands, (mesh.GetNumberOfCells(), 1)), deep=True)
    array.SetName("Reflectance")
    mesh.GetCellData().AddArray(array)
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


def cones_tuned(vectors, tuning):
    """Cones of shadow vectors that tune themselves."""
    cones = sc.vtkConeSetFilter()
    cones.SetInputConnection(vectors.GetOutputPort(0))
    cones.SetPhotonPathConnection(vectors.GetOutputPort(1))
    getattr(cones, "SetTuningTo" + tuning)()
    return cones


def tuned_cones(occluders, light, number, tuning):
    """Cones that tune themselves, of so many shadow vectors where the light hits."""
    vectors = shadow_vectors(occluders, light, number)
    vectors.SetStorageToHitPoint()
    return cones_tuned(vectors, tuning)


def visibility_volume(occluders, light, cones):
    """The visible share of the light in the fog."""
    volume = sc.vtkVisibilityVolume()
    volume.SetInputConnection(cones.GetOutputPort())
    volume.SetLightConnection(light.GetOutputPort())
    volume.SetMeshConnection(occluders.GetOutputPort())
    volume.SetBounds(*scenes.MEDIUM_BOUNDS)
    return volume


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


def palette(pictures):
    """At most 256 colours for pictures of one size: (colours, indices of the pictures)."""
    stacked = np.concatenate(pictures, axis=0)
    colors, indices = np.unique(stacked.reshape(-1, 3), axis=0, return_inverse=True)
    if len(colors) > 256:
        image = vtkImageData()
        image.SetDimensions(stacked.shape[1], stacked.shape[0], 1)
        image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(stacked).reshape(-1, 3), deep=True))
        quantize = vtkImageQuantizeRGBToIndex()
        quantize.SetInputData(image)
        quantize.SetNumberOfColors(256)
        quantize.Update()
        table = quantize.GetLookupTable()
        colors = np.array([table.GetTableValue(k)[:3] for k in range(table.GetNumberOfTableValues())])
        colors = np.round(255 * colors)
        indices = vtk_to_numpy(quantize.GetOutput().GetPointData().GetScalars())
    indices = indices.astype(np.uint8).reshape(len(pictures), *pictures[0].shape[:2])
    return colors.astype(np.uint8), indices


def save(pictures, path, levels=256, seconds=None):
    """Write a picture as PNG, or several in turn as an animated PNG that shows each for so many seconds.

    With up to 256 colours the file has a palette. Fewer levels a channel make a smaller file; 32 are enough for drawings.
    """
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    frames = list(pictures) if seconds else [pictures]
    step = 255.0 / (levels - 1)
    frames = [np.round(np.round(frame / step) * step).astype(np.uint8) for frame in frames]
    height, width, _ = frames[0].shape
    drawn = [frame[::-1] for frame in frames]
    indexed = seconds or len(np.unique(drawn[0].reshape(-1, 3), axis=0)) <= 256
    parts = [b"\x89PNG\r\n\x1a\n", chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3 if indexed else 2, 0, 0, 0))]
    if indexed:
        colors, drawn = palette(drawn)
        parts.append(chunk(b"PLTE", colors.tobytes()))
    if seconds:
        parts.append(chunk(b"acTL", struct.pack(">II", len(frames), 0)))
    for number, frame in enumerate(drawn):
        rows = np.asarray(frame, dtype=np.uint8).reshape(height, -1)
        if not indexed:  # the difference from the row above is smaller
            rows = np.concatenate([rows[:1], np.diff(rows, axis=0)])
        rows = np.concatenate([np.full((height, 1), 0 if indexed else 2, dtype=np.uint8), rows], axis=1)
        if seconds:
            control = struct.pack(">IIIIIHHBB", max(0, 2 * number - 1), width, height, 0, 0, round(1000 * seconds), 1000, 0, 0)
            parts.append(chunk(b"fcTL", control))
        head = struct.pack(">I", 2 * number) if number else b""
        parts.append(chunk(b"fdAT" if number else b"IDAT", head + zlib.compress(rows.tobytes(), 9)))
    with open(path, "wb") as file:
        file.write(b"".join(parts) + chunk(b"IEND", b""))
    print(f"wrote {path}")


def text(words, width, height):
    """Dark words in the middle of a white strip; words that are too long for it are drawn smaller."""
    style = vtkTextProperty()
    style.SetFontSize(max(6, round(0.58 * height)))
    style.SetColor(1.0, 1.0, 1.0)
    rendered = vtkImageData()
    strip = np.full((height, width, 3), 255, dtype=np.uint8)
    drawn = words and vtkTextRenderer.GetInstance().RenderString(style, words, rendered, [0, 0], 72)
    if drawn and rendered.GetDimensions()[0] > width:
        style.SetFontSize(max(6, style.GetFontSize() * width // rendered.GetDimensions()[0]))
        rendered = vtkImageData()
        drawn = vtkTextRenderer.GetInstance().RenderString(style, words, rendered, [0, 0], 72)
    if drawn:
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
    line = max(26, width // 17)

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


def stack(*pictures):
    """Pictures, the first on top; narrower ones stand in the middle."""
    width = max(picture.shape[1] for picture in pictures)
    gaps = [width - picture.shape[1] for picture in pictures]
    return np.concatenate([np.pad(picture, ((0, 0), (gap // 2, gap - gap // 2), (0, 0)), constant_values=255)
                           for picture, gap in reversed(list(zip(pictures, gaps)))], axis=0)


def color_table(low, high, bands=0):
    """The scale of colours over low..high; with bands as many even steps of it. What is no number is light grey."""
    table = vtkLookupTable()
    count = bands or 256
    table.SetNumberOfTableValues(count)
    for k, color in enumerate(scale(count)):
        table.SetTableValue(k, *(color / 255.0), 1.0)
    table.SetTableRange(low, high)
    table.SetNanColor(0.86, 0.86, 0.86, 1.0)
    return table


def category_table(colors):
    """A table for whole numbers from 0: a colour each, and grey below."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(colors))
    for k, color in enumerate(colors):
        table.SetTableValue(k, *color)
    table.SetTableRange(-0.5, len(colors) - 0.5)
    table.SetBelowRangeColor(0.93, 0.93, 0.91, 1.0)
    table.UseBelowRangeColorOn()
    return table


def paint(renderer, source, name, table, component=0, cells=False, line_width=1.0, ambient=1.0, opacity=1.0):
    """Show a data set, or the output of a filter, coloured by a point array, or by a cell array."""
    actor = add_actor(renderer, source, GREY, opacity, line_width, ambient)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetColorModeToMapScalars()
    if cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    mapper.UseLookupTableScalarRangeOn()
    mapper.SetInterpolateScalarsBeforeMapping(not cells)
    mapper.SetLookupTable(table)
    table.SetVectorModeToComponent()
    table.SetVectorComponent(component)
    return actor


def legend_line(width):
    """Height of the words of a legend."""
    return max(24, width // 40)


def legend(table, title, width, marks=5, form="{:.0f}", more=""):
    """A strip that tells what the colours mean: title above, colours, and values below; `more` follows the last value."""
    low, high = table.GetTableRange()
    line = legend_line(width)
    margin = width // 8
    ramp = np.full((line, width, 3), 255, dtype=np.uint8)
    color = [0.0, 0.0, 0.0]
    for x in range(margin, width - margin):
        table.GetColor(low + (high - low) * (x - margin + 0.5) / (width - 2 * margin), color)
        ramp[:, x] = np.round(255 * np.array(color))
    values = np.full((line, width, 3), 255, dtype=np.uint8)
    for k in range(marks):
        share = k / (marks - 1)
        word = text(form.format(low + share * (high - low)) + (more if k == marks - 1 else ""), 2 * (margin - 2), line)
        place = values[:, round(share * (width - 2 * margin)) + 2:][:, :word.shape[1]]
        np.minimum(place, word[:, :place.shape[1]], out=place)
    space = np.full((line // 3, width, 3), 255, dtype=np.uint8)
    return np.concatenate([space, values, ramp, text(title, width, line), space], axis=0)


def key(entries, width):
    """A strip that tells what single colours mean: (colour, words), side by side, in as many lines as they need."""
    line = legend_line(width)
    longest = line * (2.4 + 0.33 * max(len(words) for _, words in entries))
    columns = max(1, min(len(entries), 4 if len(entries) % 4 == 0 or len(entries) > 6 else 3, int(width / longest)))
    part = width // columns
    strips = []
    for first in range(0, len(entries), columns):
        strip = np.full((line, width, 3), 255, dtype=np.uint8)
        for k, (color, words) in enumerate(entries[first:first + columns]):
            word = text(words, part - 2 * line, line)
            inked = np.flatnonzero((word < 255).any(axis=(0, 2)))
            word = word[:, inked[0]:inked[-1] + 1]  # beside its colour
            left = k * part + line // 2
            strip[line // 5 - 1:line - line // 5 + 1, left - 1:left + line + 1] = 150  # an edge, for white
            strip[line // 5:line - line // 5, left:left + line] = np.round(255 * np.array(color))
            strip[:, left + 3 * line // 2:][:, :word.shape[1]] = word
        strips.append(strip)
    space = np.full((line // 3, width, 3), 255, dtype=np.uint8)
    return np.concatenate([space] + strips[::-1] + [space], axis=0)


def add_actor(renderer, source, color, opacity=1.0, line_width=1.0, ambient=0.0):
    """Show a mesh, a source or the output of a filter. `ambient` is the share of light that does not come from the camera."""
    mapper = vtkPolyDataMapper()
    if isinstance(source, vtkPolyData):
        mapper.SetInputData(source)
    else:
        mapper.SetInputConnection(source.GetOutputPort() if isinstance(source, vtkAlgorithm) else source)
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


def add_label(renderer, words, place, height, color=INK):
    """Words at a place in space, so many pixels high, in front of everything."""
    label = vtkBillboardTextActor3D()
    label.SetInput(words)
    label.SetPosition(*place)
    style = label.GetTextProperty()
    style.SetFontSize(max(8, round(2 * 0.75 * height)))  # four pixels become one
    style.SetColor(*color)
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToBottom()
    renderer.AddActor(label)


def camera_at(position, focal_point, view_angle=30.0, up=(0.0, 0.0, 1.0)):
    """A camera from where it stands to what it looks at."""
    camera = vtkCamera()
    camera.SetPosition(*position)
    camera.SetFocalPoint(*focal_point)
    camera.SetViewUp(*up)
    camera.SetViewAngle(view_angle)
    return camera


@functools.lru_cache(maxsize=None)
def off_screen_window():
    """One window for all pictures: a virtual display may shut down when its only window closes."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetAlphaBitPlanes(True)
    window.SetMultiSamples(0)
    return window


def render(renderer, camera, width, height=None):
    """What a renderer shows off screen, as a picture; square without a height. Needs a display."""
    height = height or width
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetActiveCamera(camera)
    renderer.SetUseDepthPeeling(True)
    renderer.SetMaximumNumberOfPeels(40)
    renderer.ResetCameraClippingRange()
    window = off_screen_window()
    window.SetSize(2 * width, 2 * height)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    window.RemoveRenderer(renderer)
    # Four pixels to one: depth peeling has no multi-sampling.
    large = pixels(grab.GetOutput()).reshape(height, 2, width, 2, 3)
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
