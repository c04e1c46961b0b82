#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Write the meshes of Data/: chair, tree, blob and the room that they stand in. The same contents every time."""

import argparse
import math
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

ROOM_HALF_WIDTH = 2.75
ROOM_HEIGHT = 5.5

# The scenes' light, for whoever builds on them: a disc of this radius, facing down.
LIGHT_CENTER = (0.0, 5.49, 0.0)
LIGHT_RADIUS = 0.5


class Mesh:
    """Points and triangles under construction."""

    def __init__(self):
        self.points = []
        self.triangles = []

    def add(self, points, triangles):
        first = len(self.points)
        self.points.extend(points)
        self.triangles.extend(tuple(first + index for index in triangle) for triangle in triangles)

    def add_box(self, low, high):
        """A closed box of 12 triangles, faces outward."""
        corners = [(x, y, z) for z in (low[2], high[2]) for y in (low[1], high[1]) for x in (low[0], high[0])]
        quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        self.add(corners, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])

    def to_poly_data(self):
        # Six decimals hide what the last bit of another machine's sine would change.
        points = vtkPoints()
        points.SetData(numpy_to_vtk(np.round(np.array(self.points), 6).astype(np.float32), deep=True))
        count = len(self.triangles)
        cells = vtkCellArray()
        cells.SetData(
            numpy_to_vtkIdTypeArray(np.arange(0, 3 * count + 1, 3, dtype=np.int64), deep=True),
            numpy_to_vtkIdTypeArray(np.array(self.triangles, dtype=np.int64).reshape(-1), deep=True))
        poly_data = vtkPolyData()
        poly_data.SetPoints(points)
        poly_data.SetPolys(cells)
        return poly_data


class Random:
    """A linear congruential generator (Numerical Recipes): the same numbers in every version of Python."""

    def __init__(self, seed):
        self.state = seed

    def uniform(self, low, high):
        self.state = (1664525 * self.state + 1013904223) % 2**32
        return low + (high - low) * self.state / 2**32


def add(a, b, factor=1.0):
    return tuple(p + factor * q for p, q in zip(a, b))


def unit(a):
    length = math.sqrt(sum(p * p for p in a))
    return tuple(p / length for p in a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def frame(axis):
    """Two unit vectors that make a right-handed frame with a unit axis."""
    u = unit(cross((0.0, 0.0, 1.0) if abs(axis[2]) < 0.9 else (1.0, 0.0, 0.0), axis))
    return u, cross(axis, u)


def make_chair():
    """27 boxes at right angles, none of which touches another: legs, rails, bars, slats of seat and back."""
    mesh = Mesh()
    gap = 0.01
    leg = 0.16
    inner = 1.0 - leg - gap

    for x in (-1.0, 1.0 - leg):
        mesh.add_box((x, 0.0, 1.0 - leg), (x + leg, 1.34, 1.0))
        mesh.add_box((x, 0.0, -1.0), (x + leg, 3.0, -1.0 + leg))

    # Rails under the seat, then bars between the legs.
    for z in (-1.0 + 0.03, 1.0 - leg + 0.03):
        mesh.add_box((-inner, 1.18, z), (inner, 1.34, z + 0.1))
    for x in (-1.0 + 0.03, 1.0 - leg + 0.03):
        mesh.add_box((x, 1.18, -inner), (x + 0.1, 1.34, inner))
        mesh.add_box((x, 0.45, -inner), (x + 0.1, 0.53, inner))
    mesh.add_box((-inner, 0.65, 1.0 - leg + 0.04), (inner, 0.73, 1.0 - leg + 0.12))

    # Eight slats of the seat, from front to back; the last stops before the back legs.
    for i in range(8):
        z = 1.0 - 0.135 - i * 0.225
        mesh.add_box((-1.0, 1.35, z), (1.0, 1.41, z + 0.135))

    # The back: two bars with six slats between them.
    for y in (1.75, 2.82):
        mesh.add_box((-inner, y, -0.98), (inner, y + 0.12, -0.9))
    for i in range(6):
        x = -0.72 + i * 0.264
        mesh.add_box((x, 1.75 + 0.12 + gap, -0.96), (x + 0.12, 2.82 - gap, -0.92))
    return mesh


def add_prism(mesh, start, end, start_radius, end_radius, sides):
    """A closed tapered prism of 4 * sides - 4 triangles, faces outward."""
    axis = unit(add(end, start, -1.0))
    u, v = frame(axis)
    points = []
    for center, radius in ((start, start_radius), (end, end_radius)):
        for i in range(sides):
            angle = 2.0 * math.pi * i / sides
            points.append(add(add(center, u, radius * math.cos(angle)), v, radius * math.sin(angle)))
    triangles = []
    for i in range(sides):
        j = (i + 1) % sides
        triangles += [(i, j, sides + j), (i, sides + j, sides + i)]
    for i in range(1, sides - 1):
        triangles += [(0, i + 1, i), (sides, sides + i, sides + i + 1)]
    mesh.add(points, triangles)


def add_leaf(mesh, stem, direction, random):
    """A quad that hangs off a twig."""
    along = unit(add(direction, tuple(random.uniform(-1.0, 1.0) for _ in range(3))))
    across = frame(along)[random.uniform(0.0, 1.0) < 0.5]
    a = add(stem, along, 0.02)
    b = add(stem, along, 0.02 + random.uniform(0.09, 0.14))
    half = random.uniform(0.025, 0.04)
    mesh.add([add(a, across, -half), add(b, across, -half), add(b, across, half), add(a, across, half)],
             [(0, 1, 2), (0, 2, 3)])


def make_tree():
    """Trunk and five generations of three branches each, and four leaves on every twig; 4.5 units high."""
    mesh = Mesh()
    random = Random(2010)

    def grow(start, direction, length, radius, level):
        end = add(start, direction, length)
        add_prism(mesh, start, end, radius, 0.7 * radius, 8 if level < 3 else 6)
        if level == 5:
            for i in range(4):
                add_leaf(mesh, add(start, direction, length * (0.4 + 0.2 * i)), direction, random)
            return
        u, v = frame(direction)
        turn = random.uniform(0.0, 2.0 * math.pi)
        for i in range(3):
            azimuth = turn + 2.0 * math.pi * (i + random.uniform(-0.15, 0.15)) / 3.0
            lean = math.radians(random.uniform(20.0, 38.0))
            sideways = add(tuple(math.cos(azimuth) * p for p in u), v, math.sin(azimuth))
            bent = unit(add(tuple(math.cos(lean) * p for p in direction), sideways, math.sin(lean)))
            child = 0.62 * radius
            grow(add(end, bent, child), bent, length * random.uniform(0.66, 0.8), child, level + 1)

    grow((0.0, 0.0, 0.0), (0.0, 1.0, 0.0), 1.4, 0.13, 0)
    scale = 4.5 / max(point[1] for point in mesh.points)
    mesh.points = [tuple(scale * p for p in point) for point in mesh.points]
    return mesh


def make_blob():
    """A closed sphere of 10,000 triangles with bumps, in the middle of the room."""
    mesh = Mesh()
    longitudes, latitudes = 100, 51
    center = (0.0, 2.5, 0.0)

    def surface(theta, phi):
        x, y, z = math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi)
        bumps = math.sin(4.0 * x + 1.0) * math.sin(5.0 * y) + math.sin(6.0 * z + 0.5) * math.cos(3.0 * x - 2.0 * y)
        return add(center, (x, y, z), 0.95 + 0.12 * bumps)

    points = [surface(0.0, 0.0), surface(math.pi, 0.0)]
    points += [surface(math.pi * i / latitudes, 2.0 * math.pi * j / longitudes)
               for i in range(1, latitudes) for j in range(longitudes)]
    triangles = []
    for j in range(longitudes):
        k = (j + 1) % longitudes
        last = 2 + (latitudes - 2) * longitudes
        triangles += [(0, 2 + k, 2 + j), (1, last + j, last + k)]
        for i in range(latitudes - 2):
            a, b = 2 + i * longitudes, 2 + (i + 1) * longitudes
            triangles += [(a + j, a + k, b + k), (a + j, b + k, b + j)]
    mesh.add(points, triangles)
    return mesh


def make_room():
    """Floor, ceiling, left, right and back wall, faces inward, with their reflectances; the front is open."""
    w, h = ROOM_HALF_WIDTH, ROOM_HEIGHT
    white = (0.70, 0.73, 0.74, 0.74, 0.74, 0.74, 0.73)
    red = (0.05, 0.05, 0.06, 0.07, 0.26, 0.58, 0.63)
    green = (0.10, 0.14, 0.38, 0.44, 0.26, 0.16, 0.15)
    black = (0.0,) * 7
    walls = [
        (white, [(-w, 0.0, -w), (-w, 0.0, w), (w, 0.0, w), (w, 0.0, -w)]),
        (white, [(-w, h, -w), (w, h, -w), (w, h, w), (-w, h, w)]),
        (red, [(-w, 0.0, -w), (-w, h, -w), (-w, h, w), (-w, 0.0, w)]),
        (green, [(w, 0.0, -w), (w, 0.0, w), (w, h, w), (w, h, -w)]),
        (black, [(-w, 0.0, -w), (w, 0.0, -w), (w, h, -w), (-w, h, -w)]),
    ]
    mesh = Mesh()
    reflectance = []
    for spectrum, corners in walls:
        mesh.add(corners, [(0, 1, 2), (0, 2, 3)])
        reflectance += [spectrum, spectrum]
    poly_data = mesh.to_poly_data()
    for name, values in (("Reflectance", np.array(reflectance, dtype=np.float32)),
                         ("OccluderId", np.full(len(reflectance), -1, dtype=np.int32))):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        poly_data.GetCellData().AddArray(array)
    return poly_data


SCENES = {
    "chair": lambda: make_chair().to_poly_data(),
    "tree": lambda: make_tree().to_poly_data(),
    "blob": lambda: make_blob().to_poly_data(),
    "cornell-box": make_room,
}


def write(poly_data, path):
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(poly_data)
    writer.SetDataModeToBinary()
    writer.SetCompressorTypeToZLib()
    writer.SetIdTypeToInt32()
    if not writer.Write():
        raise SystemExit(f"Cannot write {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    default = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Data")
    parser.add_argument("--output", default=default, help="folder to write to (default: Data of this project)")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    for name, make in SCENES.items():
        poly_data = make()
        path = os.path.join(arguments.output, name + ".vtp")
        write(poly_data, path)
        print(f"{name}: {poly_data.GetNumberOfCells()} triangles, {poly_data.GetNumberOfPoints()} points, "
              f"{os.path.getsize(path) // 1024} KiB")


if __name__ == "__main__":
    main()
