# SPDX-License-Identifier: BSD-3-Clause
"""Plane drawings: lines, arrows, areas and words in world units, seen without perspective. What the examples share."""

import common
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

PALE = (0.8, 0.8, 0.8)


def in_space(points):
    """Points of a plane as points of z = 0; those of space as they are."""
    points = np.atleast_2d(np.asarray(points, dtype=float))
    return points if points.shape[1] == 3 else np.pad(points, ((0, 0), (0, 1)))


def places(data):
    """The points of a data set, a row each."""
    return vtk_to_numpy(data.GetPoints().GetData())


def rectangle(x0, x1, y0, y1):
    """Its corners in the plane."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def circle(center, radius, first=0.0, last=360.0, corners=96):
    """Points of an arc in the plane, by degrees."""
    angle = np.radians(np.linspace(first, last, corners))
    return np.asarray(center) + radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)


class Drawing:
    """Things in space; `view` is the direction to look along, `up` what is up in the picture."""

    def __init__(self, view=(0.0, 0.0, -1.0), up=(0.0, 1.0, 0.0)):
        self.renderer = vtkRenderer()
        self.view, self.up = np.array(view, dtype=float), up
        self.layers = 0
        self.words = []

    def show(self, source, color, opacity=1.0, width=1.0, ambient=1.0):
        """A data set or the output of a filter, in front of what is there already."""
        actor = common.add_actor(self.renderer, source, color, opacity, 2.0 * width, ambient)
        self.layers += 1
        actor.SetPosition(*(-2e-3 * self.layers * self.view))
        return actor

    def cells(self, points, cells, kind, color, opacity=1.0, width=1.0):
        mesh, array = vtkPolyData(), vtkCellArray()
        mesh.SetPoints(vtkPoints())
        mesh.GetPoints().SetData(numpy_to_vtk(in_space(points), deep=True))
        for cell in cells:
            array.InsertNextCell(len(cell), [int(k) for k in cell])
        getattr(mesh, "Set" + kind)(array)
        return self.show(mesh, color, opacity, width)

    def path(self, points, color, width=1.5, opacity=1.0):
        """A line through points, so many pixels wide."""
        return self.cells(points, [range(len(points))], "Lines", color, opacity, width)

    def area(self, points, color, opacity=1.0):
        """A convex polygon."""
        return self.cells(points, [range(len(points))], "Polys", color, opacity)

    def lines(self, starts, ends, color, width=1.5, opacity=1.0):
        starts, ends = in_space(starts), in_space(ends)
        cells = [(k, k + len(starts)) for k in range(len(starts))]
        return self.cells(np.concatenate([starts, ends]), cells, "Lines", color, opacity, width)

    def dashes(self, start, end, color, dash=0.08, width=1.5):
        """A dashed line; a dash is so long in world units."""
        start, end = in_space(start)[0], in_space(end)[0]
        count = max(1, round(np.linalg.norm(end - start) / (2.0 * dash)))
        at = np.arange(count)[:, np.newaxis] / count
        return self.lines(start + at * (end - start), start + (at + 0.5 / count) * (end - start), color, width)

    def dots(self, points, color, radius):
        """Round dots in the plane of the picture."""
        right = np.cross(self.view, self.up)
        rim = circle((0.0, 0.0), radius, corners=13)[:-1] @ np.array([right, self.up])
        points = in_space(points)
        corners = (points[:, np.newaxis] + rim).reshape(-1, 3)
        return self.cells(corners, np.arange(len(corners)).reshape(len(points), -1), "Polys", color)

    def arrows(self, starts, ends, color, head=0.08, width=1.5):
        """Lines with filled heads, which are so long in world units."""
        starts, ends = in_space(starts), in_space(ends)
        along = ends - starts
        along = head * along / np.linalg.norm(along, axis=1, keepdims=True)
        across = 0.35 * np.cross(along, self.view)
        self.lines(starts, ends - 0.8 * along, color, width)
        corners = np.stack([ends, ends - along + across, ends - along - across], axis=1).reshape(-1, 3)
        return self.cells(corners, np.arange(len(corners)).reshape(-1, 3), "Polys", color)

    def say(self, words, place, color=common.INK, size=1.0):
        """Words above a place, in the middle."""
        self.words.append((words, in_space(place)[0], color, size))

    def picture(self, low, high, width):
        """The part of the plane from one corner to the other, so many pixels wide. Corners are right and up."""
        low, high = np.array(low, dtype=float), np.array(high, dtype=float)
        height = round(width * (high - low)[1] / (high - low)[0])
        for words, place, color, size in self.words:
            common.add_label(self.renderer, words, place - self.view, size * width / 27.0, color)
        right, middle = np.cross(self.view, self.up), 0.5 * (low + high)
        target = middle[0] * right + middle[1] * np.array(self.up)
        camera = vtkCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(0.5 * (high - low)[1])
        camera.SetFocalPoint(*target)
        camera.SetPosition(*(target - 50.0 * self.view))
        camera.SetViewUp(*self.up)
        return common.render(self.renderer, camera, width, height)
