# SPDX-License-Identifier: BSD-3-Clause
"""Steps of the method done again with NumPy, to be looked at and held against the filters. What the examples share."""

import common
import diagrams
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def unit(vector):
    return vector / np.linalg.norm(vector)


def frame_around(axis):
    """Two unit vectors across a unit axis, those of Core (scFrame.h): sectors are counted from them."""
    sign = np.copysign(1.0, axis[2])
    a = -1.0 / (sign + axis[2])
    b = axis[0] * axis[1] * a
    return np.array([(1.0 + sign * axis[0] ** 2 * a, sign * b, -sign * axis[0]), (b, sign + axis[1] ** 2 * a, -axis[1])])


class Fit:
    """The base around a seed, the first of the ids in `near` (section 3.2.1): rings of neighbours, counted in sectors."""

    def __init__(self, points, ways, near, sectors, ring, threshold):
        mean = unit(ways[near].sum(axis=0))
        self.normal = np.linalg.eigh(np.cov(points[near].T))[1][:, 0]
        self.normal *= np.sign(self.normal @ mean)
        offset = points[near[1:]] - points[near[0]]
        flat = offset - np.outer(offset @ self.normal / (self.normal @ mean), mean)
        places = flat @ frame_around(self.normal).T
        order = np.lexsort((near[1:], np.linalg.norm(places, axis=1)))
        self.places, ids = places[order], near[1:][order]  # in the plane, from the seed outward
        turn = np.arctan2(self.places[:, 1], self.places[:, 0]) / (2.0 * np.pi) + 0.5
        self.sectors = np.clip((turn * sectors).astype(int), 0, sectors - 1)
        self.counts = np.array([np.bincount(self.sectors[k:k + ring], minlength=sectors)
                                for k in range(0, len(ids) - ring + 1, ring)])
        self.radii = np.linalg.norm(self.places, axis=1)[ring - 1::ring][:len(self.counts)]
        self.dispersions = self.counts.var(axis=1) / self.counts.mean(axis=1)
        uneven = self.dispersions > threshold
        self.rings = int(np.argmax(uneven)) if uneven.any() else len(uneven)  # that are taken
        self.near, self.members = near, np.concatenate([near[:1], ids[:self.rings * ring]])
        self.axis = unit(ways[self.members].sum(axis=0))
        self.radius = self.radii[self.rings - 1] * (self.axis @ self.normal) if self.rings else 0.0


def fit_all(vectors, neighbors, sectors, ring, fewest, threshold):
    """Every vector that is left is a seed in its turn, as in vtkConeSetFilter with SetToPaper(). One fit a cone."""
    points = diagrams.places(vectors)
    ways = common.array(vectors.GetPointData(), "Direction").astype(float)
    left, fits = np.ones(len(points), dtype=bool), []
    for seed in range(len(points)):
        living = np.flatnonzero(left)
        if not left[seed] or len(living) <= ring:
            continue
        near = living[np.argsort(np.linalg.norm(points[living] - points[seed], axis=1), kind="stable")[:neighbors]]
        fit = Fit(points, ways, near, sectors, ring, threshold)
        if len(fit.members) >= fewest:
            left[fit.members] = False
            fits.append(fit)
    return fits


def compare(fits, vectors, cones):
    """Are these the cones of the filter?"""
    points = cones.GetPointData()
    assert len(fits) == cones.GetNumberOfPoints(), f"{len(fits)} cones here, {cones.GetNumberOfPoints()} there"
    for k, fit in enumerate(fits):
        assert np.array_equal(diagrams.places(cones)[k], diagrams.places(vectors)[fit.near[0]]), f"cone {k} has another seed"
        assert np.isclose(common.array(points, "BaseRadius")[k], fit.radius, rtol=1e-5), f"cone {k} has another radius"
        assert np.allclose(common.array(points, "Axis")[k], fit.axis, atol=1e-6), f"cone {k} has another axis"
        assert common.array(points, "VectorCount")[k] == len(fit.members), f"cone {k} has other vectors"


def ray_intervals(origin, way, begin, end, cones):
    """Where a ray is inside the cones that it meets (appendix A): which they are, and an array of (from, to)."""
    points = cones.GetPointData()
    axes = common.array(points, "Axis").astype(float)
    radii, slopes = common.array(points, "BaseRadius"), np.tan(common.array(points, "HalfAngle"))
    offset = origin - diagrams.places(cones)
    h0, h1 = np.einsum("ij,ij->i", offset, axes), axes @ way  # height above the base: h0 + h1 t
    wide = radii + slopes * h0
    a = 1.0 - h1 ** 2 - (slopes * h1) ** 2
    b = offset @ way - h0 * h1 - wide * slopes * h1
    c = np.einsum("ij,ij->i", offset, offset) - h0 ** 2 - wide ** 2
    with np.errstate(divide="ignore", invalid="ignore"):
        root = np.sqrt(b * b - a * c)
        cuts = np.nan_to_num(np.stack([(-b - root) / a, (-b + root) / a, -h0 / h1], axis=1), nan=begin)
    cuts = np.sort(np.clip(np.pad(cuts, ((0, 0), (1, 1)), constant_values=(begin, end)), begin, end), axis=1)
    which, found = [], []
    for k, cut in enumerate(cuts):
        middle = 0.5 * (cut[1:] + cut[:-1])
        height = h0[k] + h1[k] * middle
        inside = (height >= 0.0) & (a[k] * middle ** 2 + 2.0 * b[k] * middle + c[k] <= 0.0)
        inside &= (radii[k] + slopes[k] * height >= 0.0) & (np.diff(cut) > 0.0)
        if inside.any():
            which.append(k)
            found.append((cut[:-1][inside].min(), cut[1:][inside].max()))
    return which, np.array(found).reshape(-1, 2)


def some_cones(cones, which):
    """A set of some cones of another."""
    result, vertices = vtkPolyData(), vtkCellArray()
    result.SetPoints(vtkPoints())
    result.GetPoints().SetData(numpy_to_vtk(diagrams.places(cones)[which], deep=True))
    for k in range(len(which)):
        vertices.InsertNextCell(1, [k])
    result.SetVerts(vertices)
    for name in ("Axis", "BaseRadius", "HalfAngle"):
        array = numpy_to_vtk(common.array(cones.GetPointData(), name)[which], deep=True)
        array.SetName(name)
        result.GetPointData().AddArray(array)
    return result


def union(intervals):
    """Intervals that overlap become one (section 3.3.1)."""
    merged = []
    for begin, end in sorted(map(tuple, intervals)):
        if merged and begin <= merged[-1][1]:
            merged[-1][1] = max(merged[-1][1], end)
        else:
            merged.append([begin, end])
    return np.array(merged).reshape(-1, 2)
