# SPDX-License-Identifier: BSD-3-Clause
"""The edges of shadows: how wide they are, and where they lie."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import _classes as sc
from . import _lights, _meshes, _run, _save
from ._places import Places


def connect(filter_, places, mesh, light):
    """A surface, what casts shadow on it, and the lights."""
    occluders = _meshes.occluders_of(mesh)  # an output port does not keep its filter alive
    filter_.SetInputDataObject(places if places.IsA("vtkPolyData") else _meshes.data_of(places))
    filter_.SetMeshConnection(occluders.GetOutputPort())
    _lights.connect(filter_, _lights.lights_of(light))


def penumbra_width(where, mesh, light, *, normals=None, seed=1, progress=None):
    """How wide the edge of the shadow is: the distance from 5 % to 95 % of the light across it.

    Args:
        where: an (n, 3) array of points, one point, or poly data (or its path): a surface, or lines.
        mesh, light, seed, progress: as in visibility().
        normals: of an array of points: one vector, or one a point, (n, 3), of the surface that they lie on.

    Returns:
        for an array float32 (n,), of several lights (n, lights), world units, NaN where there is no edge; for poly data a new
        one with "PenumbraWidth", "PenumbraWidthError", "Visibility" and "OccluderId".

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given. KeyboardInterrupt: on Ctrl-C.

    Example:
        >>> import shadowcones as sc
        >>> half = ([[-50, -50, 0], [0, -50, 0], [0, 50, 0], [-50, 50, 0]], [[0, 1, 2, 3]])
        >>> # As long below the edge as the lamp is above it: 0.8054 of the lamp's diameter.
        >>> width = sc.penumbra_width([0, 0, -4], half, "disc:0,0,4 radius 0.5 facing -z", normals=(0, 0, 1))
        >>> 0.78 < width < 0.83
        True
    """
    places = Places(where, normals)
    if places.is_array and normals is None:
        raise ValueError("normals are needed beside an array of points: one vector, or one a point")
    widths = sc.vtkPenumbraWidth()
    connect(widths, places.data, mesh, light)
    widths.SetSeed(seed)
    _run.update(widths, progress)
    return places.answer(widths.GetOutput(0), "PenumbraWidth")


class Footprints:
    """Where shadow lies on a surface: what footprints() returns.

    Attributes:
        outlines: vtkPolyData, closed polylines, the shadow on their left.
        areas: vtkPolyData, polygons without gaps.
        names: the occluders' names by "OccluderId".
    """

    def __init__(self, outlines, areas):
        self.outlines = outlines
        self.areas = areas
        names = outlines.GetFieldData().GetAbstractArray("OccluderNames")
        self.names = [names.GetValue(i) for i in range(names.GetNumberOfValues())] if names else []

    def area(self, umbra=False):
        """Square world units in shadow, or in the umbra alone; where footprints overlap each of them counts."""
        total = 0.0
        classes = vtk_to_numpy(self.areas.GetCellData().GetArray("ShadowClass"))
        points = vtk_to_numpy(self.areas.GetPoints().GetData()) if len(classes) else np.zeros((0, 3))
        polygons = self.areas.GetPolys()
        offsets = vtk_to_numpy(polygons.GetOffsetsArray())
        corners = vtk_to_numpy(polygons.GetConnectivityArray())
        for cell in np.flatnonzero(classes == 2) if umbra else range(len(classes)):
            p = points[corners[offsets[cell]:offsets[cell + 1]]]
            total += 0.5 * np.linalg.norm(np.cross(p[1:-1] - p[0], p[2:] - p[0]).sum(axis=0))
        return float(total)

    def save(self, path):
        """Write the outlines: geojson for maps, vtp, stl, ply or obj, by the path's extension.

        Raises ValueError for another extension, and OSError where the file cannot be written.
        """
        _save.save(self.outlines, path, {".geojson": sc.vtkShadowFootprintWriter, **_save.MESHES})

    def __repr__(self):
        return f"<shadowcones.Footprints {self.outlines.GetNumberOfLines()} outlines of {len(self.names)} occluders>"


def footprints(where, mesh, light, *, spacing=None, seed=1, progress=None):
    """Outlines and areas of the shadow on a surface, of each occluder by its name.

    Args:
        where: the surface: a path, any VTK data set, or (points, faces) arrays.
        mesh, light, seed, progress: as in visibility().
        spacing: longest side of the triangles that are looked at first, world units; what is smaller may be missed. Default: a
            hundredth of the surface's diagonal.

    Returns:
        Footprints: outlines and areas (vtkPolyData, cell data "ShadowClass" (1 penumbra, 2 umbra), "OccluderId", "LightId"),
        area(), save(path).

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given. KeyboardInterrupt: on Ctrl-C.

    Example:
        >>> import shadowcones as sc
        >>> ground = ([[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]], [[0, 1, 2, 3]])
        >>> plate = ([[-1, -1, 2], [1, -1, 2], [1, 1, 2], [-1, 1, 2]], [[0, 1, 2, 3]])
        >>> found = sc.footprints(ground, {"roof": plate}, "sun: direction -z diameter 0")
        >>> found.names, round(found.area(), 1)
        (['roof'], 4.0)
    """
    outlines = sc.vtkShadowFootprints()
    connect(outlines, _meshes.data_of(where), mesh, light)
    if spacing is not None:
        outlines.SetSpacing(spacing)
    outlines.SetSeed(seed)
    _run.update(outlines, progress)
    return Footprints(outlines.GetOutput(0), outlines.GetOutput(1))
