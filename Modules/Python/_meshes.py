# SPDX-License-Identifier: BSD-3-Clause
"""Whatever people have as a mesh, as occluders: files, data sets, arrays, lists and dictionaries of these."""

import collections.abc
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray, vtkCompositeDataSet, vtkDataObjectTree, vtkDataSet, vtkMultiBlockDataSet, vtkPolyData)
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from . import _classes as sc
from . import _run

KINDS = ("a path, a VTK data set, (points, faces) arrays, an object with vertices and faces, "
         "or a list or dictionary of these")


def is_path(mesh):
    return isinstance(mesh, (str, os.PathLike))


def is_pair(mesh):
    """Whether that is (points, faces) and not two meshes."""
    return isinstance(mesh, tuple) and len(mesh) == 2 and not any(
        is_path(part) or isinstance(part, (vtkDataSet, vtkAlgorithm, dict)) for part in mesh)


def points_of(array, what="points"):
    """vtkPoints of an (n, 3) array; float32 and float64 are not copied."""
    array = np.asarray(array)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what} must be an (n, 3) array, not one of shape {array.shape}")
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{what} must be numbers, not {array.dtype}")
    if array.dtype not in (np.float32, np.float64):
        array = array.astype(np.float64)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(array)))
    return points


def check_indices(connectivity, offsets, number):
    """Every face has three corners and more, each of them a point that is there."""
    if np.any(np.diff(offsets) < 3):
        face = int(np.argmax(np.diff(offsets) < 3))
        raise ValueError(f"face {face} has {offsets[face + 1] - offsets[face]} corners: three are the least")
    wrong = (connectivity < 0) | (connectivity >= number)
    if np.any(wrong):
        at = int(np.argmax(wrong))
        face = int(np.searchsorted(offsets, at, side="right")) - 1
        raise ValueError(f"face {face} uses point {connectivity[at]}, of {number} points, which count from 0")


def packed_faces(faces):
    """Connectivity and offsets of faces as VTK packs them: n, a, b, c, ..., n, a, ..."""
    offsets, keep, at = [0], np.ones(len(faces), dtype=bool), 0
    while at < len(faces):
        count = int(faces[at])
        if count < 0 or at + count >= len(faces):
            raise ValueError(f"the packed faces end inside the face that begins at index {at}")
        keep[at] = False
        offsets.append(offsets[-1] + count)
        at += count + 1
    return faces[keep], np.array(offsets, dtype=np.int64)


def faces_of(faces, number):
    """vtkCellArray of an (m, k) array, of a list of lists, or of packed faces."""
    try:
        array = np.asarray(faces)
    except ValueError:  # lists of different lengths, in newer NumPy
        array = np.empty(0, dtype=object)
    if array.dtype == object:
        lengths = [len(face) for face in faces]
        offsets = np.concatenate(([0], np.cumsum(lengths))).astype(np.int64)
        array = np.array([corner for face in faces for corner in face])
    elif array.ndim == 2:
        offsets = np.arange(len(array) + 1, dtype=np.int64) * array.shape[1]
    elif array.ndim == 1:
        array, offsets = packed_faces(array)
    else:
        raise ValueError(f"faces must be an (m, 3) array, a list of lists or a packed array, not of shape {array.shape}")
    if array.size and array.dtype.kind not in "iu":
        raise ValueError(f"faces must be whole numbers, not {array.dtype}")
    connectivity = np.ascontiguousarray(array, dtype=np.int64).reshape(-1)
    check_indices(connectivity, offsets, number)
    cells = vtkCellArray()
    # Copied: VTK shares the numbers and lets go of the arrays that would hold NumPy's memory.
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True), numpy_to_vtkIdTypeArray(connectivity, deep=True))
    return cells


def polydata_of(points, faces):
    mesh = vtkPolyData()
    mesh.SetPoints(points_of(points))
    mesh.SetPolys(faces_of(faces, mesh.GetNumberOfPoints()))
    return mesh


def read_files(paths):
    """The vtkMeshFiles of paths. Raises FileNotFoundError or ValueError with its sentence."""
    files = sc.vtkMeshFiles()
    for path in paths:
        files.AddFileName(os.fspath(path))
    if not files.Read():
        missing = [path for path in paths if not os.path.exists(path)]
        raise (FileNotFoundError if missing else ValueError)(files.GetError())
    return files


def raw_of(mesh):
    """One mesh as the data set or composite that it is."""
    if is_path(mesh):
        return read_files([mesh]).GetMesh(0)
    if isinstance(mesh, vtkAlgorithm):
        mesh = _run.update(mesh).GetOutputDataObject(0)
    if isinstance(mesh, (vtkDataSet, vtkDataObjectTree)):
        return mesh
    if is_pair(mesh):
        return polydata_of(*mesh)
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return polydata_of(mesh.vertices, mesh.faces)
    raise TypeError(f"a mesh must be {KINDS}, not {type(mesh).__name__}")


def data_of(mesh):
    """One mesh as vtkPolyData, or as the composite that it is: for what takes no volumes."""
    data = raw_of(mesh)
    if isinstance(data, (vtkPolyData, vtkDataObjectTree)):
        return data
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(data)
    surface.Update()
    return surface.GetOutput()


def named_meshes(mesh):
    """[(name, mesh)] of a list or a dictionary; None of a single mesh."""
    if isinstance(mesh, collections.abc.Mapping):
        return [(str(name), part) for name, part in mesh.items()]
    if isinstance(mesh, (list, tuple)) and not is_pair(mesh):
        if not mesh:
            raise ValueError("the list of meshes is empty")
        names = []
        for number, part in enumerate(mesh):
            stem = os.path.splitext(os.path.basename(os.fspath(part)))[0] if is_path(part) else str(number)
            names.append(stem if stem not in names else f"{stem} {number + 1}")
        return list(zip(names, mesh))
    return None


def occluders_of(mesh):
    """A vtkLabelOccluders of anything that is a mesh: one occluder each of several, else one a component."""
    occluders = sc.vtkLabelOccluders()
    several = named_meshes(mesh)
    if several is None:
        data = raw_of(mesh)
        occluders.SetInputDataObject(data)
        if isinstance(data, vtkDataSet) and data.GetCellData().HasArray("OccluderId"):
            occluders.SetLabelByToArray()
        return occluders
    blocks = vtkMultiBlockDataSet()
    for number, (name, part) in enumerate(several):
        blocks.SetBlock(number, raw_of(part))
        blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)
    occluders.SetInputDataObject(blocks)
    occluders.SetLabelByToBlock()
    return occluders
