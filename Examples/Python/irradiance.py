#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A small museum: lux on the walls, the floor and the pedestals under two lamps, and where a limit for paper is passed.

Writes irradiance.png: illuminance, and the places that get more than a limit of 150 lux. Drawing needs a display."""

import os

import common
import numpy as np
import shadowcones as sc
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkRegularPolygonSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkRenderer

LIMIT, HIGHEST = 150.0, 300.0  # lux; of the maps
LAMPS = ((-1.3, -0.5, 5000.0), (1.4, 0.4, 3600.0))  # x, y, lumen


def lamp(x, y, lumen):
    """A round panel of 40 cm at 3.4 m that shines down: a Lambertian disc sends pi^2 R^2 L watts."""
    light = sc.vtkAreaLightSource()
    light.SetCenter(x, y, 3.4)
    light.SetNormal(0.0, 0.0, -1.0)
    light.SetRadius(0.2)
    light.SetNumberOfWavelengths(1)
    light.SetRadiance(lumen / 683.0 / (np.pi ** 2 * 0.2 ** 2))
    return light


def wall(origin, first, second, points):
    """A rectangle of so many points a side, whose normal looks into the room."""
    plane = vtkPlaneSource()
    plane.SetOrigin(*origin)
    plane.SetPoint1(*np.add(origin, first))
    plane.SetPoint2(*np.add(origin, second))
    plane.SetResolution(points - 1, points - 1)
    return plane


def exhibits():
    """Two pedestals with a ball on each, off the floor by a hair."""
    parts = vtkAppendPolyData()
    for x, y, height in ((-1.1, 0.3, 1.0), (1.2, -0.2, 0.7)):
        stand = vtkCubeSource()
        stand.SetBounds(x - 0.25, x + 0.25, y - 0.25, y + 0.25, 0.0, height)
        ball = vtkSphereSource()
        ball.SetCenter(x, y, height + 0.3)
        ball.SetRadius(0.3)
        ball.SetThetaResolution(96)
        ball.SetPhiResolution(64)
        for part in (stand, ball):
            parts.AddInputConnection(part.GetOutputPort())
    occluders = sc.vtkLabelOccluders()
    occluders.SetInputConnection(parts.GetOutputPort())
    return occluders


def surfaces(occluders, points):
    """What is looked at: floor, back wall, side wall and the exhibits themselves, with normals."""
    room = vtkAppendPolyData()
    for sides in (((-2.5, -2.0, 0.0), (5.0, 0.0, 0.0), (0.0, 4.0, 0.0)), ((-2.5, 2.0, 0.0), (5.0, 0.0, 0.0), (0.0, 0.0, 3.0)),
                  ((-2.5, -2.0, 0.0), (0.0, 4.0, 0.0), (0.0, 0.0, 3.0))):
        part = wall(*sides, points)
        room.AddInputConnection(part.GetOutputPort())
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(occluders.GetOutputPort())
    fine = vtkLinearSubdivisionFilter()
    fine.SetInputConnection(triangles.GetOutputPort())
    fine.SetNumberOfSubdivisions(2)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(fine.GetOutputPort())
    normals.ConsistencyOff()
    room.AddInputConnection(normals.GetOutputPort())
    return room


def view(probe, table, size, name="Illuminance"):
    """From the open side of the room."""
    renderer = vtkRenderer()
    common.paint(renderer, probe.GetOutputPort(), name, table)
    for x, y, _ in LAMPS:
        disc = vtkRegularPolygonSource()
        disc.SetCenter(x, y, 3.4)
        disc.SetRadius(0.2)
        disc.SetNumberOfSides(48)
        common.add_actor(renderer, disc.GetOutputPort(), common.YELLOW, ambient=1.0)
    return common.render(renderer, common.camera_at((4.9, -9.2, 5.4), (-0.05, 0.0, 1.3), 29.0), size, size * 3 // 4)


def above_limit():
    """Greys up to the limit, one colour above."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(400)
    for k in range(400):
        lux = HIGHEST * (k + 0.5) / 400
        grey = 0.3 + 0.6 * min(lux / LIMIT, 1.0)
        table.SetTableValue(k, *(common.VERMILION if lux > LIMIT else (grey, grey, grey)), 1.0)
    table.SetTableRange(0.0, HIGHEST)
    return table


def main():
    options = common.parser(__doc__, size=740)
    options.add_argument("--points", type=int, default=91, help="points along the sides of floor and walls (default: 91)")
    options.add_argument("--samples", type=int, default=128, help="light samples a point (default: 128)")
    arguments = common.parse(options)
    occluders = exhibits()
    lights = [lamp(*one) for one in LAMPS]
    probe = sc.vtkConeSetProbe()
    room = surfaces(occluders, arguments.points)
    probe.SetInputConnection(room.GetOutputPort())
    probe.SetMeshConnection(occluders.GetOutputPort())
    for light in lights:
        probe.AddLightConnection(light.GetOutputPort())
    probe.ComputeIlluminanceOn()
    probe.SetLuminousEfficacySpectrum(0, 683.0)  # the lamps' watts are lumens over 683
    probe.SetNumberOfLightSamples(arguments.samples)
    probe.Update()
    data = probe.GetOutput().GetPointData()
    lux = common.array(data, "Illuminance")
    error = common.array(data, "IlluminanceError")
    print(f"{len(lux):,} places: up to {lux.max():.0f} lux, {np.mean(lux > LIMIT):.1%} of them above {LIMIT:.0f} lux; "
          f"largest standard error {error.max():.1f} lux")

    size = arguments.size
    table = common.color_table(0.0, HIGHEST, bands=12)
    picture = common.table([[view(probe, table, size), view(probe, above_limit(), size)]],
                           ["illuminance", f"more than {LIMIT:.0f} lux, the limit for paper"])
    entries = [((0.6, 0.6, 0.6), f"up to {LIMIT:.0f} lux"), (common.VERMILION, f"above {LIMIT:.0f} lux"), (common.YELLOW, "lamps")]
    strips = (common.legend(table, "Illuminance, lux", picture.shape[1], marks=7, more=" and more"), common.key(entries, picture.shape[1]))
    common.save(common.stack(picture, *strips), os.path.join(arguments.output, "irradiance.png"), 64)


if __name__ == "__main__":
    main()
