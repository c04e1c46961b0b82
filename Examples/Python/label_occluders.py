#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What vtkLabelOccluders finds in a mesh, and a picture: a colour an occluder, open edges red."""

import os

import common
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

COUNTS = ("NumberOfOccluders", "TriangulatedPolygons", "WeldedPoints", "DroppedCells", "FlippedTriangles",
          "NonManifoldEdges", "BoundaryEdges")


def default_meshes(data):
    """Two meshes of this project, and the real ones where they are installed."""
    real = [os.path.join(common.REAL_MESHES, name) for name in ("bunny.obj", "horse.3ds", "cat.3ds")]
    own = [os.path.join(data, name) for name in ("chair.vtp", "tree.vtp")]
    return own + [path for path in real if os.path.exists(path)]


def report(name, output):
    field = output.GetFieldData()
    closed = common.array(field, "OccluderClosed")
    counts = "".join(f"{field.GetArray(count).GetValue(0):22,}" for count in COUNTS)
    print(f"{name:<14}{output.GetNumberOfCells():10,}{counts}{int(closed.sum()):8,}", flush=True)


def color_by_id(output):
    """A colour for every occluder, far from that of its neighbour in number."""
    ids = common.array(output.GetCellData(), "OccluderId")
    hue = (ids * 0.61803398875 % 1.0)[:, np.newaxis] + np.array([0.0, 1.0 / 3.0, 2.0 / 3.0])
    colors = 170.0 + 60.0 * np.cos(2.0 * np.pi * hue)
    array = numpy_to_vtk(colors.astype(np.uint8), deep=True)
    array.SetName("Colors")
    output.GetCellData().SetScalars(array)


def picture(output, size):
    color_by_id(output)
    edges = vtkFeatureEdges()
    edges.SetInputData(output)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.ColoringOff()
    renderer = vtkRenderer()
    common.add_actor(renderer, output, common.GREY, ambient=0.3).GetMapper().ScalarVisibilityOn()
    common.add_actor(renderer, edges.GetOutputPort(), common.RED, line_width=3.0, ambient=1.0)
    camera = vtkCamera()
    camera.SetPosition(4.5, 2.0, 9.0)
    camera.SetViewAngle(24.0)
    renderer.SetActiveCamera(camera)
    renderer.ResetCamera()
    camera.Zoom(0.98)
    return common.render(renderer, camera, size)


def main():
    options = common.parser(__doc__, size=300)
    options.add_argument("meshes", nargs="*", help=".vtp, .obj, .ply, .stl or .3ds files (default: chair, tree, and "
                         "bunny, horse and cat of glmark2-data where installed)")
    arguments = common.parse(options)
    print(f"{'':<14}{'triangles':>10}{''.join(f'{count:>22}' for count in COUNTS)}{'closed':>8}")
    names, pictures = [], []
    for path in arguments.meshes or default_meshes(arguments.data):
        occluders = sc.vtkLabelOccluders()
        occluders.SetInputData(common.stand_in_room(path, 3.0))
        occluders.Update()
        name = os.path.splitext(os.path.basename(path))[0]
        report(name, occluders.GetOutput())
        names.append(name)
        pictures.append(picture(occluders.GetOutput(), arguments.size))
    common.save(common.table([pictures], names), os.path.join(arguments.output, "label-occluders.png"), levels=32)


if __name__ == "__main__":
    main()
