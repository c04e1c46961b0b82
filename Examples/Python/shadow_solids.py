#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shadows as solids of what is truly seen: a house under the Sun, a ring under a lamp, cut open. Needs a display."""

import math
import os

import common
import scenes
import shadow_volume
import shadowcones as sc
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import vtkRenderer


def house():
    """Ten by ten and twenty high, under a Sun of half a degree at 45 degrees."""
    cube = vtkCubeSource()
    cube.SetBounds(0.0, 10.0, 0.0, 20.0, 0.0, 10.0)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(cube.GetOutputPort())
    triangles.Update()
    sun = sc.vtkAreaLightSource()
    sun.SetShapeToSun()
    sun.SetNormal(1.0, -1.0, 0.0)
    sun.SetAngularDiameter(2.0)  # four times the true one, to be seen
    return triangles.GetOutput(), sun, (10.0, 45.0, 0.0, 20.0, -5.0, 15.0)


def ring(corners=96):
    """A flat ring half way under a lamp."""
    points, faces = vtkPoints(), vtkCellArray()
    for k in range(corners):
        angle = 2.0 * math.pi * k / corners
        for radius in (0.5, 1.2):
            points.InsertNextPoint(radius * math.cos(angle), 2.6, radius * math.sin(angle))
    for k in range(corners):
        a, b = 2 * k, 2 * ((k + 1) % corners)
        faces.InsertNextCell(4, (a, a + 1, b + 1, b))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(faces)
    return mesh, scenes.ceiling_light(), (-2.7, 2.7, 0.0, 5.2, -2.7, 2.7)


def shadow_solids(mesh, light, bounds, resolution):
    solids = sc.vtkShadowVolume()
    solids.SetMethodToVisibility()
    solids.SetMeshData(mesh)
    solids.SetLightConnection(light.GetOutputPort())
    solids.SetBounds(*bounds)
    solids.SetResolution(resolution)
    solids.Update()
    return solids


def picture(mesh, solids, plane, view, size):
    """The halves behind a plane across z; the umbra a little in front of the cut face of the penumbra."""
    renderer = vtkRenderer()
    shown = vtkTriangleFilter()
    shown.SetInputData(mesh)
    # A little nearer to the light, so that what lies in one plane is not drawn in spots.
    common.add_actor(renderer, shown.GetOutputPort(), common.GREY, ambient=0.3).SetPosition(0.0, 0.001 * view[2], 0.0)
    umbra = common.add_actor(
        renderer, shadow_volume.cut(solids.GetOutput(1), plane), shadow_volume.UMBRA, ambient=0.4)
    umbra.SetPosition(0.0, 0.0, 0.004 * view[2])
    common.add_actor(renderer, shadow_volume.cut(solids.GetOutput(0), plane), shadow_volume.PENUMBRA, ambient=0.35)
    camera = common.camera_at(view[:3], view[3], view[4], (0.0, 1.0, 0.0))
    return common.render(renderer, camera, size, size * 3 // 4)


def main():
    options = common.parser(__doc__, size=700)
    options.add_argument("--resolution", type=int, default=64, help="cells along a solid's longest side (default: 64)")
    arguments = common.parse(options)
    views = {"house": (5.02, (32.0, 22.0, 62.0, (18.5, 9.0, 5.0), 31.0)),
             "ring": (0.02, (3.0, 3.6, 9.0, (0.2, 1.35, 0.0), 29.0))}
    pictures = []
    for name, scene in (("house", house()), ("ring", ring())):
        solids = shadow_solids(*scene, arguments.resolution)
        print(name)
        shadow_volume.report("  penumbra", solids.GetOutput(0))
        shadow_volume.report("  umbra", solids.GetOutput(1))
        pictures.append(picture(scene[0], solids, *views[name], arguments.size))
    shown = common.table([pictures], ["a house under the Sun, cut open", "a ring under a lamp, cut open"])
    entries = ((shadow_volume.PENUMBRA, "penumbra: a part of the light is hidden"), (shadow_volume.UMBRA, "umbra: all of it is"))
    common.save(common.stack(shown, common.key(entries, shown.shape[1])), os.path.join(arguments.output, "shadow-solids.png"), 64)


if __name__ == "__main__":
    main()
