#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Hours in the Sun of a courtyard, its roofs and its walls, on three days of the year. Needs a display."""

import os

import common
import numpy as np
import shadowcones as sc
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkFeatureEdges
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkRenderer

# Metres: x is east, y is north. Around a yard of 24 by 16.
HOUSES = {
    "north wing": (-18.0, 18.0, 8.0, 16.0, 0.0, 12.0),
    "east wing": (12.0, 18.0, -8.0, 8.0, 0.0, 9.0),
    "west wing": (-18.0, -12.0, -8.0, 8.0, 0.0, 9.0),
    "south wing": (-18.0, 18.0, -14.0, -8.0, 0.0, 5.0),
    "tower": (-11.0, -5.0, -20.0, -14.0, 0.0, 24.0),
}
DAYS = {"March": "2024-03-20", "June": "2024-06-21", "December": "2024-12-21"}
LATITUDE, LONGITUDE = 48.14, 11.58
MOST = 16.0  # hours, the end of the scale of colours


def town():
    """Every house is a block with its name, and one occluder."""
    blocks = vtkMultiBlockDataSet()
    for number, (name, bounds) in enumerate(HOUSES.items()):
        house = vtkCubeSource()
        house.SetBounds(*bounds)
        house.Update()
        blocks.SetBlock(number, house.GetOutput())
        blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)
    occluders = sc.vtkLabelOccluders()
    occluders.SetInputData(blocks)
    return occluders


def sheet(origin, first, second, cell):
    """A rectangle of small cells."""
    plane = vtkPlaneSource()
    plane.SetOrigin(*origin)
    plane.SetPoint1(*np.add(origin, first))
    plane.SetPoint2(*np.add(origin, second))
    plane.SetResolution(*(max(1, round(np.linalg.norm(edge) / cell)) for edge in (first, second)))
    plane.Update()
    return plane.GetOutput()


def places(cell):
    """The ground, and the walls and roofs of the houses, in cells of about that size."""
    append = vtkAppendPolyData()
    append.AddInputData(sheet((-26, -26, 0), (52, 0, 0), (0, 50, 0), cell))
    for x0, x1, y0, y1, z0, z1 in HOUSES.values():
        x, y, z = (x1 - x0, 0, 0), (0, y1 - y0, 0), (0, 0, z1 - z0)
        for origin, first, second in (((x0, y0, z1), x, y), ((x0, y0, z0), x, z), ((x0, y1, z0), x, z),
                                      ((x0, y0, z0), y, z), ((x1, y0, z0), y, z)):
            append.AddInputData(sheet(origin, first, second, cell))
    append.Update()
    return append.GetOutput()


def hours_of(where, occluders, date, step):
    """A day from midnight to midnight, UTC."""
    path = sc.vtkSunPath()
    path.SetLatitude(LATITUDE)
    path.SetLongitude(LONGITUDE)
    path.SetStart(date + "T00:00:00Z")
    path.SetEnd(date + "T24:00:00Z")
    path.SetStep(step)
    hours = sc.vtkSunHours()
    hours.SetInputData(where)
    hours.SetMeshConnection(occluders.GetOutputPort())
    hours.SetPathConnection(path.GetOutputPort())
    hours.SetAssociationToCells()
    hours.SetNumberOfLightSamples(16)
    hours.ComputeOccludersOn()
    hours.Update()
    return hours.GetOutput()


def report(day, answered):
    """The middle of the yard: how long, from when to when, and whose shadow it is that takes most."""
    data = answered.GetCellData()
    middle = int(np.argmin(np.linalg.norm(common.centers(answered), axis=1)))
    occluder = data.GetArray("OccluderId").GetValue(middle)
    names = answered.GetFieldData().GetAbstractArray("OccluderNames")
    name = names.GetValue(occluder) if occluder >= 0 else "nobody"
    hours, first, last, error = (data.GetArray(array).GetValue(middle)
                                 for array in ("SunHours", "FirstSun", "LastSun", "SunHoursError"))
    print(f"{day:<9} {hours:5.2f} h of Sun in the middle of the yard (+- {error:.2f}), from {first:5.2f} to {last:5.2f} h UTC; "
          f"most of the shadow is that of the {name}", flush=True)


def view(answered, occluders, table, size):
    """The town from the south, its cells in the colours of their hours."""
    renderer = vtkRenderer()
    common.paint(renderer, answered, "SunHours", table, cells=True)
    edges = vtkFeatureEdges()
    edges.SetInputConnection(occluders.GetOutputPort())
    edges.ColoringOff()
    common.add_actor(renderer, edges.GetOutputPort(), common.INK, line_width=2.0, ambient=1.0)
    return common.render(renderer, common.camera_at((38.0, -62.0, 78.0), (-1.0, -6.0, 3.0), 35.0), size, size * 3 // 4)


def main():
    options = common.parser(__doc__, size=600)
    options.add_argument("--cell", type=float, default=0.5, help="edge of a cell in metres (default: 0.5)")
    options.add_argument("--step", type=float, default=10.0, help="minutes between two places of the Sun (default: 10)")
    arguments = common.parse(options)
    occluders, where = town(), places(arguments.cell)
    pictures, table = [], common.color_table(0.0, MOST)
    for day, date in DAYS.items():
        answered = hours_of(where, occluders, date, arguments.step)
        report(day, answered)
        pictures.append(view(answered, occluders, table, arguments.size))
    picture = common.table([pictures], [f"{day}, latitude {LATITUDE:.0f} north" for day in DAYS])
    strip = common.legend(table, "Hours in the Sun on one day", picture.shape[1], marks=9, form="{:.0f} h")
    common.save(common.stack(picture, strip), os.path.join(arguments.output, "sun-hours.png"), levels=64)


if __name__ == "__main__":
    main()
