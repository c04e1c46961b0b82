#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Hours in the Sun of a courtyard, its roofs and its walls, on three days of the year. Needs a display."""

import common
import drawing
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkRenderingCore import vtkRenderer

DAYS = {"March": "2024-03-20", "June": "2024-06-21", "December": "2024-12-21"}


def hours_of(where, occluders, path):
    """How long every cell sees the Sun on its path."""
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
    middle = int(np.argmin(np.linalg.norm(common.centers(answered), axis=1)))
    names = ("SunHours", "SunHoursError", "FirstSun", "LastSun", "OccluderId")
    hours, error, first, last, occluder = (answered.GetCellData().GetArray(name).GetValue(middle) for name in names)
    print(f"{day:<9} {hours:5.2f} h of Sun in the middle of the yard (+- {error:.2f}), from {first:5.2f} to "
          f"{last:5.2f} h UTC; most of the shadow is that of the {[*scenes.COURTYARD, 'nobody'][occluder]}", flush=True)


def main():
    options = common.parser(__doc__, size=600)
    options.add_argument("--cell", type=float, default=0.5, help="edge of a cell in metres (default: 0.5)")
    options.add_argument("--step", type=float, default=10.0, help="minutes between two places of the Sun (default: 10)")
    arguments = common.parse(options)
    occluders, where = scenes.courtyard(), scenes.courtyard_surfaces(arguments.cell)
    pictures, table = [], common.color_table(0.0, 16.0)
    for day, date in DAYS.items():
        answered = hours_of(where, occluders, scenes.sun_of_day(date, arguments.step))
        report(day, answered)
        renderer, camera = vtkRenderer(), common.camera_at((38.0, -62.0, 78.0), (-1.0, -6.0, 3.0), 35.0)
        common.paint(renderer, answered, "SunHours", table, cells=True)
        drawing.add_edges(renderer, occluders)
        pictures.append(common.render(renderer, camera, arguments.size, arguments.size * 3 // 4))
    picture = common.table([pictures], [f"{day}, latitude 48 north" for day in DAYS])
    strip = common.legend(table, "Hours in the Sun on one day", picture.shape[1], marks=9, form="{:.0f} h")
    common.save(common.stack(picture, strip), f"{arguments.output}/sun-hours.png", 64)


if __name__ == "__main__":
    main()
