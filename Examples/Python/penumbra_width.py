#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How wide the edges of shadows are: a board that leans over the floor, and a ball, under a round lamp.

Writes penumbra-width.png: the width at every point of the floor that lies in an edge, and some of the ways on which they are
measured. Prints the width along a line next to what a ruler and the rule of three give. Drawing needs a display."""

import os

import common
import shadowcones as sc
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkLineSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

LAMP_HEIGHT, LAMP_RADIUS = 4.0, 0.25
BOARD_HEIGHT = 1.2  # of the level board beside the leaning one


def occluders():
    """A board that leans from the floor up to 1.7, a ball that floats, and a level board."""
    board = vtkCubeSource()
    board.SetBounds(0.0, 2.6, -0.35, 0.35, -0.01, 0.01)
    lean = vtkTransform()
    lean.Translate(-1.6, -0.7, 0.02)
    lean.RotateY(-40.0)
    leaning = vtkTransformPolyDataFilter()
    leaning.SetInputConnection(board.GetOutputPort())
    leaning.SetTransform(lean)
    ball = vtkSphereSource()
    ball.SetCenter(0.9, 0.8, 0.9)
    ball.SetRadius(0.35)
    ball.SetThetaResolution(64)
    ball.SetPhiResolution(48)
    level = vtkCubeSource()
    level.SetBounds(-1.2, -0.2, 0.5, 1.1, BOARD_HEIGHT, BOARD_HEIGHT + 0.01)
    parts = vtkAppendPolyData()
    for part in (leaning, ball, level):
        parts.AddInputConnection(part.GetOutputPort())
    labels = sc.vtkLabelOccluders()
    labels.SetInputConnection(parts.GetOutputPort())
    return labels


def floor(points):
    plane = vtkPlaneSource()
    plane.SetOrigin(-2.5, -2.0, 0.0)
    plane.SetPoint1(2.5, -2.0, 0.0)
    plane.SetPoint2(-2.5, 2.0, 0.0)
    plane.SetResolution(points - 1, 4 * (points - 1) // 5)
    return plane


def widths(where, light, mesh, samples):
    """The filter, run."""
    width = sc.vtkPenumbraWidth()
    width.SetInputConnection(where.GetOutputPort())
    width.SetLightConnection(light.GetOutputPort())
    width.SetMeshConnection(mesh.GetOutputPort())
    width.SetNumberOfLightSamples(samples)
    width.Update()
    return width


def camera():
    result = vtkCamera()
    result.SetPosition(0.2, -4.6, 5.6)
    result.SetFocalPoint(0.0, -0.05, 0.25)
    result.SetViewUp(0.0, 0.0, 1.0)
    result.SetViewAngle(33.0)
    return result


def main():
    options = common.parser(__doc__, size=620)
    options.add_argument("--points", type=int, default=221, help="points along the floor (default: 221)")
    options.add_argument("--samples", type=int, default=256, help="light samples a place (default: 256)")
    arguments = common.parse(options)
    light = sc.vtkAreaLightSource()
    light.SetCenter(0.0, 0.0, LAMP_HEIGHT)
    light.SetNormal(0.0, 0.0, -1.0)
    light.SetRadius(LAMP_RADIUS)
    mesh = occluders()
    on_floor = widths(floor(arguments.points), light, mesh, arguments.samples)
    found = common.array(on_floor.GetOutput(1).GetCellData(), "PenumbraWidth")
    print(f"{on_floor.GetOutput().GetNumberOfPoints():,} points, {len(found):,} of them in an edge: widths from "
          f"{found.min():.3f} to {found.max():.3f}")

    line = vtkLineSource()  # out of the level board's shadow, square to its edge
    line.SetPoint1(-1.0, 0.3, 0.0)
    line.SetPoint2(-1.0, 1.2, 0.0)
    along = widths(line, light, mesh, 4096).GetOutput(1).GetCellData()
    exact = 1.612 * LAMP_RADIUS * BOARD_HEIGHT / (LAMP_HEIGHT - BOARD_HEIGHT)
    print(f"edge of the level board: {common.array(along, 'PenumbraWidth')[0]:.4f} measured "
          f"(at most {common.array(along, 'PenumbraWidthError')[0]:.4f} off), {exact:.4f} by the rule of three")

    size = arguments.size
    table = common.color_table(0.0, 0.4, bands=16)
    sparse = floor(max(3, arguments.points // 4))
    ways = widths(sparse, light, mesh, arguments.samples)
    pictures = []
    for with_ways in (False, True):
        renderer = vtkRenderer()
        if with_ways:
            common.add_actor(renderer, sparse.GetOutputPort(), (0.86, 0.86, 0.86), ambient=1.0)
            lines = common.paint(renderer, ways.GetOutputPort(1), "PenumbraWidth", table, cells=True, line_width=3.0)
            lines.SetPosition(0.0, 0.0, 0.01)
        else:
            common.paint(renderer, on_floor.GetOutputPort(0), "PenumbraWidth", table)
        common.add_actor(renderer, mesh.GetOutputPort(), (0.75, 0.75, 0.78), ambient=0.4, opacity=0.8)
        pictures.append(common.render(renderer, camera(), size))
    picture = common.table([pictures], ["Width at each point", "The ways, from 5 % to 95 % of the light"])
    strip = common.legend(table, "Width of the penumbra, world units (grey: lit or in umbra)",
                        picture.shape[1], marks=9, form="{:.2f}")
    common.save(common.stack(picture, strip), os.path.join(arguments.output, "penumbra-width.png"), 64)


if __name__ == "__main__":
    main()
