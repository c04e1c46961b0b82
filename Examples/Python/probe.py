#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Where the light goes: the tree's shadow in a grid of tetrahedra, and the chair's on the walls of the room.

Writes probe-grid.png, a cut through the grid asked by rays (Exact) and by the cones' discs alone (Soft), and
probe-surface.png, visibility and shadow class on the room and on the chair itself. Drawing needs a display."""

import os

import common
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter, vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer


def probe_of(data, cones, light, mesh=None):
    """A probe of a data set: Exact with a mesh, Soft without."""
    probe = sc.vtkConeSetProbe()
    probe.SetInputConnection(data.GetOutputPort())
    probe.SetConeSetConnection(cones.GetOutputPort())
    probe.SetLightConnection(light.GetOutputPort())
    if mesh:
        probe.SetMeshConnection(mesh.GetOutputPort())
    else:
        probe.SetMethodToSoft()
    return probe


def tetrahedra(number):
    """An unstructured grid in the room."""
    grid = vtkImageData()
    grid.SetDimensions(number, number, number)
    low, high = np.reshape(scenes.MEDIUM_BOUNDS, (3, 2)).T
    grid.SetOrigin(low)
    grid.SetSpacing((high - low) / (number - 1))
    cells = vtkDataSetTriangleFilter()
    cells.SetInputData(grid)
    return cells


def fine_surface(mesh, divisions):
    """A mesh cut into small triangles, with normals of its faces; faces that meet in an edge share no points."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(mesh)
    fine = vtkLinearSubdivisionFilter()
    fine.SetInputConnection(triangles.GetOutputPort())
    fine.SetNumberOfSubdivisions(divisions)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(fine.GetOutputPort())
    normals.ConsistencyOff()
    normals.SetFeatureAngle(10.0)
    return normals


CLASSES = ((1.0, 0.93, 0.6), common.ORANGE, (0.12, 0.15, 0.4))


def show(renderer, source, name):
    """An output coloured by an array of the probe, "Visibility" or "ShadowClass"."""
    table = common.category_table(CLASSES) if name == "ShadowClass" else common.color_table(0.0, 1.0)
    common.paint(renderer, source.GetOutputPort(), name, table)


def report(title, probe):
    """One line on what a probe found."""
    probe.Update()
    data = probe.GetOutput().GetPointData()
    shares = np.bincount(common.array(data, "ShadowClass"), minlength=3) / probe.GetOutput().GetNumberOfPoints()
    print(f"{title}: {probe.GetOutput().GetNumberOfPoints():,} points, {shares[0]:.1%} lit, {shares[1]:.1%} penumbra, "
          f"{shares[2]:.1%} umbra, {len(np.unique(common.array(data, 'OccluderId'))) - 1} occluders seen", flush=True)


def scale_of_visibility(width):
    return common.legend(common.color_table(0.0, 1.0), "Visible share of the lamp", width, marks=6, form="{:.1f}")


def cut_view(occluders, probe, size):
    """A plane through the grid, with the mesh."""
    plane = vtkPlane()
    plane.SetNormal(0.0, 0.0, 1.0)
    plane.SetOrigin(0.0, 0.0, 0.003)
    cut = vtkCutter()
    cut.SetCutFunction(plane)
    cut.SetInputConnection(probe.GetOutputPort())
    renderer = vtkRenderer()
    show(renderer, cut, "Visibility")
    common.add_actor(renderer, occluders.GetOutputPort(), (0.25, 0.5, 0.25), ambient=0.4)
    camera = vtkCamera()
    camera.SetPosition(0.0, 2.6, 12.0)
    camera.SetFocalPoint(0.0, 2.6, 0.0)
    camera.SetViewAngle(27.0)
    return common.render(renderer, camera, size)


def grid_picture(arguments, light):
    """The tree's shadow in tetrahedra, by rays and by discs."""
    tree = scenes.label(scenes.read(os.path.join(arguments.data, "tree.vtp")))
    grid = tetrahedra(arguments.grid)
    exact = probe_of(grid, common.tuned_cones(tree, light, arguments.vectors, "Conservative"), light, tree)
    soft = probe_of(grid, common.tuned_cones(tree, light, arguments.vectors, "Soft"), light)
    report("grid, Exact", exact)
    report("grid, Soft", soft)
    error = common.array(soft.GetOutput().GetPointData(), "Visibility") - common.array(
        exact.GetOutput().GetPointData(), "Visibility")
    print(f"Soft against Exact: root mean square {np.sqrt(np.mean(error ** 2)):.3f}, mean {np.mean(error):+.3f}")
    pictures = [cut_view(tree, exact, arguments.size), cut_view(tree, soft, arguments.size)]
    picture = common.table([pictures], ["Exact: rays inside cones", "Soft: discs alone"])
    common.save(common.stack(picture, scale_of_visibility(picture.shape[1])),
                os.path.join(arguments.output, "probe-grid.png"), 64)


def surface_picture(arguments, light):
    """The chair's shadow on the walls and on the chair."""
    chair = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))
    chair.Update()
    bounds = common.tuned_cones(chair, light, arguments.vectors, "Conservative")
    room = scenes.read(os.path.join(arguments.data, "cornell-box.vtp"))
    walls = probe_of(fine_surface(room, 7), bounds, light, chair)
    itself = probe_of(fine_surface(chair.GetOutput(), 4), bounds, light, chair)
    report("room", walls)
    report("chair", itself)
    camera = vtkCamera()
    camera.SetPosition(2.2, 3.9, 11.5)
    camera.SetFocalPoint(0.0, 2.0, 0.0)
    camera.SetViewAngle(30.0)
    pictures = []
    for name in ("Visibility", "ShadowClass"):
        renderer = vtkRenderer()
        for probe in (walls, itself):
            show(renderer, probe, name)
        pictures.append(common.render(renderer, camera, arguments.size))
    picture = common.table([pictures], ["visible share of the lamp", "class of shadow"])
    width = picture.shape[1]
    classes = common.key(list(zip(CLASSES, ("lit", "penumbra", "umbra"))), width)
    common.save(common.stack(picture, scale_of_visibility(width), classes),
                os.path.join(arguments.output, "probe-surface.png"), 64)


def main():
    options = common.parser(__doc__, size=640, vectors=50000)
    options.add_argument("--grid", type=int, default=72, help="points along an edge of the grid (default: 72)")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    grid_picture(arguments, light)
    surface_picture(arguments, light)


if __name__ == "__main__":
    main()
