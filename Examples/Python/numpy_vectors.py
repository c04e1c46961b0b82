#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Cones from shadow vectors and photon paths that another tracer made: here a tiny one in NumPy.

A disc light over a slatted panel and three balls. Nothing but points and the documented arrays goes to
vtkConeSetFilter: "Direction" and "EmissionPoint" of the vectors, "PathState", "EmissionPoint" and "Direction" of the
paths. It tunes itself three ways; the tracer then measures the cones with rays of its own. Writes numpy-vectors.png,
for which it needs a display."""

import os

import common
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkCamera

LIGHT_CENTER = np.array([0.0, 4.0, 0.0])  # faces down
LIGHT_RADIUS = 0.3
FLOOR = 2.5  # half the width of the square floor at height 0
SLAT_HEIGHT = 2.4
SLATS = [(x, x + 0.25) for x in np.arange(-0.95, 0.7, 0.4)]  # from x to x
SLAT_HALF_LENGTH = 0.9  # along z
BALLS = [((-1.5, 1.2, -0.3), 0.35), ((1.5, 0.9, 0.4), 0.45), ((0.2, 1.1, 1.5), 0.3)]
KINDS = ["Conservative", "Preview", "Soft"]


# The tracer


def hit_distance(origins, directions):
    """Along each ray the distance to the first slat or ball; infinity where there is none."""
    with np.errstate(divide="ignore", invalid="ignore"):
        nearest = (SLAT_HEIGHT - origins[:, 1]) / directions[:, 1]
        x, z = (origins[:, axis] + nearest * directions[:, axis] for axis in (0, 2))
    on_slat = np.any([(x > low) & (x < high) for low, high in SLATS], axis=0) & (np.abs(z) < SLAT_HALF_LENGTH)
    nearest = np.where(on_slat & (nearest > 1e-9), nearest, np.inf)
    for center, radius in BALLS:
        offset = origins - center
        half = np.sum(offset * directions, axis=1)
        root = half**2 - np.sum(offset**2, axis=1) + radius**2
        reach = np.sqrt(np.maximum(root, 0.0))
        for distance in (-half - reach, -half + reach):
            nearest = np.where((root > 0.0) & (distance > 1e-9), np.minimum(nearest, distance), nearest)
    return nearest


def light_points(random, number):
    """Points spread evenly over the light."""
    radius, angle = LIGHT_RADIUS * np.sqrt(random.random(number)), 2.0 * np.pi * random.random(number)
    return LIGHT_CENTER + np.stack([radius * np.cos(angle), np.zeros(number), radius * np.sin(angle)], axis=1)


def trace(number):
    """Photons until `number` are blocked: emission points, directions, ends, and which are blocked."""
    random = np.random.default_rng(1)
    parts, blocked_so_far = [], 0
    while blocked_so_far < number:
        emission = light_points(random, 20000)
        square, angle = random.random(20000), 2.0 * np.pi * random.random(20000)
        # Lambertian, as every light of the filters.
        directions = np.stack([np.sqrt(square) * np.cos(angle), -np.sqrt(1.0 - square),
                               np.sqrt(square) * np.sin(angle)], axis=1)
        distance = hit_distance(emission, directions)
        blocked = np.isfinite(distance)
        with np.errstate(divide="ignore"):
            distance = np.where(blocked, distance, -emission[:, 1] / directions[:, 1])
        ends = emission + distance[:, np.newaxis] * directions
        kept = blocked | np.all(np.abs(ends) <= FLOOR, axis=1)  # on an occluder or on the floor
        parts.append([emission[kept], directions[kept], ends[kept], blocked[kept]])
        blocked_so_far += np.count_nonzero(blocked)
    emission, directions, ends, blocked = (np.concatenate(part) for part in zip(*parts))
    last = np.flatnonzero(blocked)[number - 1] + 1
    return emission[:last], directions[:last], ends[:last], blocked[:last]


# From NumPy to VTK and back


def poly_data(points, **arrays):
    """A vertex for each point, with point data by name: the output of a filter."""
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    vertices = vtkVertexGlyphFilter()
    vertices.SetInputData(data)
    return vertices


def tuned_cones(vectors, paths, kind):
    """A cone set that chooses its own parameters."""
    cones = sc.vtkConeSetFilter()
    cones.SetInputConnection(vectors.GetOutputPort())
    cones.SetPhotonPathConnection(paths.GetOutputPort())
    getattr(cones, "SetTuningTo" + kind)()
    cones.Update()
    return cones


class Cones:
    """The documented arrays of a cone set."""

    def __init__(self, output):
        data = output.GetPointData()
        self.centers = common.vtk_to_numpy(output.GetPoints().GetData())
        self.axes, self.normals = common.array(data, "Axis"), common.array(data, "Normal")
        self.radii, self.angles = common.array(data, "BaseRadius"), common.array(data, "HalfAngle")

    def contain(self, points):
        """Which points lie inside a cone."""
        inside = np.zeros(len(points), dtype=bool)
        for center, axis, radius, angle in zip(self.centers, self.axes, self.radii, self.angles):
            offset = points - center
            height = offset @ axis
            distance = np.linalg.norm(offset - height[:, np.newaxis] * axis, axis=1)
            inside |= (height >= 0.0) & (distance <= radius + height * np.tan(angle))
        return inside

    def discs_between(self, starts, ends):
        """Which segments pass a base disc."""
        passed = np.zeros(len(starts), dtype=bool)
        for center, normal, radius in zip(self.centers, self.normals, self.radii):
            with np.errstate(divide="ignore", invalid="ignore"):
                along = ((center - starts) @ normal) / ((ends - starts) @ normal)
                crossing = starts + along[:, np.newaxis] * (ends - starts) - center
                passed |= (along > 0.0) & (along < 1.0) & (np.linalg.norm(crossing, axis=1) <= radius)
        return passed


class Judge:
    """Random points between panel and floor, each with a random point of the light: is the way between them free?"""

    def __init__(self, number):
        random = np.random.default_rng(2)
        self.points = np.array([-FLOOR, 0.0, -FLOOR]) + random.random((number, 3)) * (2 * FLOOR, SLAT_HEIGHT, 2 * FLOOR)
        self.light = light_points(random, number)
        way = self.points - self.light
        length = np.linalg.norm(way, axis=1)
        distance = hit_distance(self.light, way / length[:, np.newaxis])
        inside_ball = np.any(
            [np.linalg.norm(self.points - center, axis=1) < radius for center, radius in BALLS], axis=0)
        self.blocked = distance < length
        # What the light point sends to this point: the cosine at the light over the squared distance.
        self.weight = np.where(inside_ball, 0.0, -way[:, 1] / length**3)

    def measure(self, caught):
        """Recall and precision of what is said to be blocked; lit light lost over all blocked light."""
        blocked, both, said = (np.sum(self.weight[which]) for which in (self.blocked, self.blocked & caught, caught))
        return both / blocked, both / said, (said - both) / blocked


def report(kind, cones, judge):
    """What tuning chose, and what the tracer finds."""
    field = cones.GetOutput().GetFieldData()
    value = {name: common.array(field, name)[0] for name in (
        "NumberOfNeighbors", "NumberOfSectors", "PointsPerRing", "MinimumVectorsPerCone", "VarianceThreshold",
        "ExpansionFraction", "RadiusScale", "Overlap", "CosineCorrection", "TuningObjective", "TuningLeak",
        "TuningLost", "TuningFits")}
    print(f"{kind}: {common.summary(cones)}\n"
          f"  chosen of {value['TuningFits']} fits: p = {value['NumberOfNeighbors']}, {value['NumberOfSectors']}, "
          f"{value['PointsPerRing']}, {value['MinimumVectorsPerCone']}; VarianceThreshold "
          f"{value['VarianceThreshold']:.2f}, ExpansionFraction {value['ExpansionFraction']:.3f}, RadiusScale "
          f"{value['RadiusScale']:.3f}, Overlap {value['Overlap']}, CosineCorrection {value['CosineCorrection']}\n"
          f"  held-out photons: objective {value['TuningObjective']:.4f}, leak {value['TuningLeak']:.4f}, lost "
          f"{value['TuningLost']:.4f}")
    shape = Cones(cones.GetOutput())
    for name, caught in (("inside cones", shape.contain(judge.points)),
                         ("behind discs", shape.discs_between(judge.light, judge.points))):
        recall, precision, lost = judge.measure(caught)
        print(f"  the tracer, {name}: recall {recall:.4f}, precision {precision:.3f}, lost {lost:.4f}",
              flush=True)


# The picture


def shapes():
    """The slats and balls as a mesh, to look at only."""
    scene = vtkAppendPolyData()
    for low, high in SLATS:
        slat = vtkPlaneSource()
        slat.SetOrigin(low, SLAT_HEIGHT, -SLAT_HALF_LENGTH)
        slat.SetPoint1(high, SLAT_HEIGHT, -SLAT_HALF_LENGTH)
        slat.SetPoint2(low, SLAT_HEIGHT, SLAT_HALF_LENGTH)
        scene.AddInputConnection(slat.GetOutputPort())
    for center, radius in BALLS:
        ball = scenes.ball(center, radius, 48)
        scene.AddInputConnection(ball.GetOutputPort())
    return scene


def camera():
    view = vtkCamera()
    view.SetPosition(3.4, 5.6, 8.2)
    view.SetFocalPoint(0.0, 1.4, 0.1)
    view.SetViewAngle(24.0)
    return view


def main():
    options = common.parser(__doc__, size=420, vectors=5800)
    options.add_argument("--points", type=int, default=50000,
                         help="points at which the tracer measures (default: 50000)")
    arguments = common.parse(options)

    emission, directions, ends, blocked = trace(arguments.vectors)
    vectors = poly_data(ends[blocked], Direction=directions[blocked], EmissionPoint=emission[blocked])
    paths = poly_data(ends, PathState=blocked.astype(np.int32), EmissionPoint=emission, Direction=directions)
    print(f"{len(blocked):,} photons, {np.count_nonzero(blocked):,} blocked")

    judge = Judge(arguments.points)
    pictures = []
    for kind in KINDS:
        cones = tuned_cones(vectors, paths, kind)
        report(kind, cones, judge)
        # Soft is about the discs: hardly a cone in its picture.
        length = 0.1 if kind == "Soft" else 1.5
        pictures.append(common.cone_view(shapes(), vectors, cones, length, camera(), arguments.size))
    common.save(common.table([pictures], KINDS), os.path.join(arguments.output, "numpy-vectors.png"), 32)


if __name__ == "__main__":
    main()
