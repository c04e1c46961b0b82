# SPDX-License-Identifier: BSD-3-Clause
"""Maps of values on surfaces, with legends that can be read by every eye: what some examples share."""

import common
import numpy as np
from vtkmodules.vtkCommonCore import vtkLookupTable

CIVIDIS = common.SCALE / 255.0
# Of Okabe and Ito.
ORANGE = (0.90, 0.62, 0.0)
SKY_BLUE = (0.34, 0.71, 0.91)
GREEN = (0.0, 0.62, 0.45)
DARK_BLUE = (0.0, 0.28, 0.53)
VERMILION = (0.84, 0.37, 0.0)


def color_table(low, high, bands=0):
    """Cividis over low..high; with bands as many even steps of it. Values that are not numbers are light grey."""
    table = vtkLookupTable()
    count = bands or 256
    table.SetNumberOfTableValues(count)
    places = np.linspace(0.0, 1.0, len(CIVIDIS))
    for k, at in enumerate(np.linspace(0.0, 1.0, count)):
        table.SetTableValue(k, *[np.interp(at, places, CIVIDIS[:, c]) for c in range(3)], 1.0)
    table.SetTableRange(low, high)
    table.SetNanColor(0.86, 0.86, 0.86, 1.0)
    return table


def paint(renderer, source, name, table, component=0, cells=False, line_width=1.0):
    """Show an output coloured by a point array, or by a cell array."""
    actor = common.add_actor(renderer, source, common.GREY, ambient=1.0, line_width=line_width)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetColorModeToMapScalars()
    if cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    mapper.UseLookupTableScalarRangeOn()
    mapper.SetInterpolateScalarsBeforeMapping(not cells)
    mapper.SetLookupTable(table)
    table.SetVectorModeToComponent()
    table.SetVectorComponent(component)
    return actor


def legend(table, title, width, marks=5, form="{:.0f}"):
    """A strip that tells what the colours mean: title above, colours, and values below. The lowest row comes first."""
    low, high = table.GetTableRange()
    line = max(24, width // 32)
    margin = width // 10
    ramp = np.full((line, width, 3), 255, dtype=np.uint8)
    color = [0.0, 0.0, 0.0]
    for x in range(margin, width - margin):
        table.GetColor(low + (high - low) * (x - margin + 0.5) / (width - 2 * margin), color)
        ramp[:, x] = np.round(255 * np.array(color))
    values = np.full((line, width, 3), 255, dtype=np.uint8)
    for k in range(marks):
        share = k / (marks - 1)
        word = common.text(form.format(low + share * (high - low)), 2 * (margin - 2), line)
        middle = margin + round(share * (width - 2 * margin))
        values[:, middle - margin + 2:middle + margin - 2][:, :word.shape[1]] = np.minimum(
            values[:, middle - margin + 2:middle + margin - 2][:, :word.shape[1]], word)
    return np.concatenate([values, ramp, common.text(title, width, line)], axis=0)


def key(entries, width):
    """A strip that tells what single colours mean: (colour, words) side by side."""
    line = max(24, width // 32)
    part = width // len(entries)
    cells = []
    for color, words in entries:
        cell = np.full((line, part, 3), 255, dtype=np.uint8)
        cell[:, line:] = common.text(words, part - line, line)
        cell[line // 4:line - line // 4, line // 2:3 * line // 2] = np.round(255 * np.array(color))
        cells.append(cell)
    strip = np.concatenate(cells, axis=1)
    return np.pad(strip, ((0, 0), (0, width - strip.shape[1]), (0, 0)), constant_values=255)


def stack(*pictures):
    """Pictures of one width, the first on top."""
    return np.concatenate([picture for picture in reversed(pictures)], axis=0)
