#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A page to hand on: the chair, its cones, and what is lit at heights that a slider picks, in one HTML file."""

import os

import common
import scenes
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkPlaneSource


def level(height, points):
    """A square plane across the room."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-2.7, height, 2.7)
    plane.SetPoint1(2.7, height, 2.7)
    plane.SetPoint2(-2.7, height, -2.7)
    plane.SetResolution(points, points)
    return plane


def main():
    options = common.parser(__doc__, 120, vectors=5800)
    options.add_argument("--levels", type=int, default=12, help="number of heights (default: 12)")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    occluders = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))

    vectors = sc.vtkShadowVectorFilter()
    vectors.SetInputConnection(occluders.GetOutputPort())
    vectors.SetLightConnection(light.GetOutputPort())
    vectors.SetTargetNumberOfVectors(arguments.vectors)
    cones = sc.vtkConeSetFilter()
    cones.SetInputConnection(vectors.GetOutputPort(0))
    cones.SetPhotonPathConnection(vectors.GetOutputPort(1))
    cones.SetMeshConnection(occluders.GetOutputPort())
    cones.Update()

    page = sc.vtkShadowPage()
    page.SetTitle("A chair under a lamp: the visible share of the lamp at each height")
    page.SetViewUp(0, 1, 0)
    page.SetViewDirection(1, 0.9, 1.6)
    page.AddMesh(occluders.GetOutput(), "Chair")
    page.AddCones(cones.GetOutput(), "Cones", 1.0)
    for step in range(arguments.levels):
        height = 2.4 * step / max(1, arguments.levels - 1)
        plane = level(height, arguments.size)
        probe = sc.vtkConeSetProbe()
        probe.SetInputConnection(plane.GetOutputPort())
        probe.SetConeSetConnection(cones.GetOutputPort())
        probe.SetMeshConnection(occluders.GetOutputPort())
        probe.SetLightConnection(light.GetOutputPort())
        probe.UseNormalsOff()
        probe.Update()
        page.AddAnswer(probe.GetOutput(), "Visibility", f"height {height:.2f}")
    path = os.path.join(arguments.output, "shadow-page.html")
    if not page.Write(path):
        raise SystemExit(1)
    print(f"wrote {path}")


if __name__ == "__main__":
    main()
