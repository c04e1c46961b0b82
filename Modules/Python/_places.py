# SPDX-License-Identifier: BSD-3-Clause
"""Where something is asked: points as an array, or a data set; and answers in the same form."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import _meshes, _run


class Places:
    """Where a filter is to answer.

    An (n, 3) array, or one point of 3 numbers, is answered by an array; a data set, the path of one, or a filter that has
    one, by the data set with the filter's arrays.
    """

    def __init__(self, where, normals=None):
        self.single = False
        if isinstance(where, vtkAlgorithm):
            where = _run.update(where).GetOutputDataObject(0)
        self.is_array = not (isinstance(where, vtkDataSet) or _meshes.is_path(where))
        if not self.is_array:
            if normals is not None:
                raise ValueError("normals go with an array of points; a data set carries its own")
            self.data = _meshes.data_of(where) if _meshes.is_path(where) else where
            return
        array = np.asarray(where)
        self.single = array.shape == (3,)
        points = array[np.newaxis] if self.single else array
        self.data = vtkPolyData()
        self.data.SetPoints(_meshes.points_of(points, "where"))
        if normals is not None:
            self.set_normals(np.asarray(normals, dtype=float))

    def set_normals(self, normals):
        number = self.data.GetNumberOfPoints()
        if normals.shape not in ((3,), (number, 3)):
            raise ValueError(f"normals must be one vector, or one a point, ({number}, 3), not of shape {normals.shape}")
        array = numpy_to_vtk(np.ascontiguousarray(np.broadcast_to(normals, (number, 3))), deep=True)
        array.SetName("Normals")
        self.data.GetPointData().SetNormals(array)

    def answer(self, output, name, cells=False):
        """An array of the output as NumPy sees it, or the output itself."""
        if not self.is_array:
            # A data set of its own: the filter and what feeds it may go.
            result = output.NewInstance()
            result.ShallowCopy(output)
            return result
        attributes = output.GetCellData() if cells else output.GetPointData()
        values = vtk_to_numpy(attributes.GetArray(name))
        if not self.single:
            return values
        return values[0].item() if values.ndim == 1 else values[0]  # a plain number, or one of each light
