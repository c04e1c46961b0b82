#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whose shadow covers how much of the ground: outlines and areas of the umbra and penumbra of a post, a ball and a frame.

Writes footprints.png, a plan of the ground, and footprints.geojson, the outlines for map tools. Drawing needs a display."""

import json
import os

import common
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

COLORS = {"post": common.DARK_BLUE, "ball": common.ORANGE, "frame": common.TEAL}


def things():
    """Three occluders as named blocks."""
    ball = vtkSphereSource()
    ball.SetCenter(0.2, -1.1, 0.9)
    ball.SetRadius(0.4)
    ball.SetThetaResolution(96)
    ball.SetPhiResolution(64)
    ball.Update()
    frame = vtkAppendPolyData()
    for bar in ((0.5, 1.9, 0.5, 0.7), (0.5, 1.9, 1.5, 1.7), (0.5, 0.7, 0.7, 1.5), (1.7, 1.9, 0.7, 1.5)):
        frame.AddInputData(scenes.box(*bar, 1.0, 1.05))
    frame.Update()
    blocks = vtkMultiBlockDataSet()
    for k, (name, mesh) in enumerate({"post": scenes.box(-1.6, -1.2, 0.2, 0.6, 0.0, 1.6), "ball": ball.GetOutput(),
                                      "frame": frame.GetOutput()}.items()):
        blocks.SetBlock(k, mesh)
        blocks.GetMetaData(k).Set(blocks.NAME(), name)
    return blocks


def part_of(prints, port, occluder, shadow_class):
    """The cells of one occluder and class."""
    first = vtkThreshold()
    first.SetInputConnection(prints.GetOutputPort(port))
    first.SetInputArrayToProcess(0, 0, 0, 1, "OccluderId")
    second = vtkThreshold()
    second.SetInputConnection(first.GetOutputPort())
    second.SetInputArrayToProcess(0, 0, 0, 1, "ShadowClass")
    for step, value in ((first, occluder), (second, shadow_class)):
        step.SetLowerThreshold(value - 0.5)
        step.SetUpperThreshold(value + 0.5)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(second.GetOutputPort())
    return surface


def plan(prints, names, size):
    """The ground from above: umbrae in full colour, penumbrae pale, outlines dark."""
    renderer = vtkRenderer()
    ground = vtkPlaneSource()
    ground.SetOrigin(-3.0, -3.0, -0.01)
    ground.SetPoint1(3.0, -3.0, -0.01)
    ground.SetPoint2(-3.0, 3.0, -0.01)
    common.add_actor(renderer, ground.GetOutputPort(), (0.95, 0.95, 0.93), ambient=1.0)
    for occluder, name in enumerate(names):
        color = np.array(COLORS[name])
        for shadow_class, shade in ((1, 1.0 - 0.45 * (1.0 - color)), (2, color)):
            areas = part_of(prints, 1, occluder, shadow_class)
            actor = common.add_actor(renderer, areas.GetOutputPort(), shade, ambient=1.0, opacity=0.85)
            actor.SetPosition(0.0, 0.0, 0.001 * occluder)
            outlines = part_of(prints, 0, occluder, shadow_class)
            line = common.add_actor(
                renderer, outlines.GetOutputPort(), (0.1, 0.1, 0.1), ambient=1.0, line_width=1.0 + shadow_class)
            line.SetPosition(0.0, 0.0, 0.02)
    camera = vtkCamera()
    camera.ParallelProjectionOn()
    camera.SetParallelScale(1.95)
    camera.SetPosition(0.0, 0.45, 10.0)
    camera.SetFocalPoint(0.0, 0.45, 0.0)
    camera.SetViewUp(0.0, 1.0, 0.0)
    return common.render(renderer, camera, size, size * 3 // 4)


def main():
    options = common.parser(__doc__, size=1200)
    options.add_argument("--spacing", type=float, default=0.06, help="side of the triangles that are asked (default: 0.06)")
    arguments = common.parse(options)
    ground = vtkPlaneSource()
    ground.SetOrigin(-3.0, -3.0, 0.0)
    ground.SetPoint1(3.0, -3.0, 0.0)
    ground.SetPoint2(-3.0, 3.0, 0.0)
    lamp = sc.vtkAreaLightSource()
    lamp.SetCenter(0.0, 0.0, 4.5)
    lamp.SetNormal(0.0, 0.0, -1.0)
    lamp.SetRadius(0.35)
    prints = sc.vtkShadowFootprints()
    prints.SetInputConnection(ground.GetOutputPort())
    prints.SetLightConnection(lamp.GetOutputPort())
    prints.SetMeshData(things())
    prints.SetSpacing(arguments.spacing)
    writer = sc.vtkShadowFootprintWriter()
    writer.SetInputConnection(prints.GetOutputPort(0))
    path = os.path.join(arguments.output, "footprints.geojson")
    writer.SetFileName(path)
    writer.Write()
    with open(path, encoding="utf-8") as file:
        for feature in json.load(file)["features"]:
            known = feature["properties"]
            rings = feature["geometry"]["coordinates"]
            print(f"{known['OccluderName']}, {known['Shadow']}: {known['Area']:.3f} square units, {len(rings) - 1} holes, "
                  f"{len(rings[0]) - 1} corners")
    table = prints.GetOutput(0).GetFieldData().GetAbstractArray("OccluderNames")
    names = [table.GetValue(k) for k in range(table.GetNumberOfValues())]
    picture = plan(prints, names, arguments.size)
    strip = common.key([(COLORS[name], f"{name} (pale: penumbra)") for name in names], arguments.size)
    common.save(common.stack(picture, strip), os.path.join(arguments.output, "footprints.png"), 64)


if __name__ == "__main__":
    main()
