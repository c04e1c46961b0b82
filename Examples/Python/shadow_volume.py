#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shadows as solids of a sheet of paper and of the chair, cut open: penumbra blue, umbra dark. Needs a display."""

import os

import common
import scenes
import shadowcones as sc
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPlaneCollection
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkMassProperties, vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkClipClosedSurface
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

PENUMBRA = (0.45, 0.62, 0.95)
UMBRA = (0.12, 0.13, 0.3)


def paper():
    """A round sheet in the middle of the room."""
    sheet = vtkRegularPolygonSource()
    sheet.SetNumberOfSides(128)
    sheet.SetRadius(0.8)
    sheet.SetCenter(0.0, 3.0, 0.0)
    sheet.SetNormal(0.0, 1.0, 0.0)
    sheet.GeneratePolylineOff()
    sheet.Update()
    return sheet.GetOutput()


def bounding_cones(vectors):
    """Few and large cones that are bounds."""
    cones = common.cone_set(vectors)
    cones.SetNumberOfNeighbors(4000)
    cones.SetPointsPerRing(40)
    cones.SetVarianceThreshold(2.0)
    cones.SetExpansionToLightGeometry()
    cones.SetOverlap(True)
    return cones


def shadow_solids(cones, resolution):
    """One solid for all occluders, from the cones to the walls of the room."""
    solids = sc.vtkShadowVolume()
    solids.SetInputConnection(cones.GetOutputPort())
    solids.SetBounds(-2.7, 2.7, 0.0, 5.2, -2.7, 2.7)
    solids.SetResolution(resolution)
    solids.SetUmbraToBaseDiscs()
    solids.PerOccluderOff()
    solids.Update()
    return solids


def cut(solid, z=0.02):
    """The half behind a plane across z, closed again; by default through the middle of the room."""
    plane = vtkPlane()
    plane.SetOrigin(0.0, 0.0, z)
    plane.SetNormal(0.0, 0.0, -1.0)
    planes = vtkPlaneCollection()
    planes.AddItem(plane)
    clip = vtkClipClosedSurface()
    clip.SetInputData(solid)
    clip.SetClippingPlanes(planes)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(clip.GetOutputPort())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(triangles.GetOutputPort())
    normals.SetFeatureAngle(35.0)
    normals.Update()
    return normals.GetOutput()


def report(name, solid):
    """Volume, and edges that a closed manifold does not have."""
    if solid.GetNumberOfCells() == 0:
        print(f"{name:<18} empty")
        return
    mass = vtkMassProperties()
    mass.SetInputData(solid)
    edges = vtkFeatureEdges()
    edges.SetInputData(solid)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    print(f"{name:<18}{solid.GetNumberOfCells():10,} triangles, volume {mass.GetVolume():7.3f}, "
          f"{edges.GetOutput().GetNumberOfCells()} open or non-manifold edges")


def picture(occluders, solids, size):
    renderer = vtkRenderer()
    common.add_actor(renderer, occluders.GetOutputPort(), common.GREY, ambient=0.3)
    umbra = cut(solids.GetOutput(1))
    umbra_actor = common.add_actor(renderer, umbra, UMBRA, ambient=0.4)
    umbra_actor.SetPosition(0.0, -0.03, 0.01)  # in front of the penumbra's cut face
    common.add_actor(renderer, cut(solids.GetOutput(0)), PENUMBRA, ambient=0.35)
    camera = vtkCamera()
    camera.SetPosition(4.0, 2.9, 9.5)
    camera.SetFocalPoint(0.1, 1.5, -0.6)
    camera.SetViewAngle(29.0)
    return common.render(renderer, camera, size)


def main():
    options = common.parser(__doc__, size=700, vectors=20000)
    options.add_argument("--resolution", type=int, default=96, help="cells along a solid's longest side (default: 96)")
    arguments = common.parse(options)
    pictures = []
    meshes = {"sheet of paper": paper(), "chair": scenes.read(os.path.join(arguments.data, "chair.vtp"))}
    for name, mesh in meshes.items():
        occluders = scenes.label(mesh)
        cones = bounding_cones(common.shadow_vectors(occluders, scenes.ceiling_light(), arguments.vectors))
        print(f"{name}: {common.summary(cones)}")
        solids = shadow_solids(cones, arguments.resolution)
        report("  penumbra", solids.GetOutput(0))
        report("  umbra", solids.GetOutput(1))
        pictures.append(picture(occluders, solids, arguments.size))
    shown = common.table([pictures], list(meshes))
    strip = common.key(((PENUMBRA, "penumbra, at most"), (UMBRA, "umbra, by the base discs")), shown.shape[1])
    common.save(common.stack(shown, strip), os.path.join(arguments.output, "shadow-volume.png"), levels=64)


if __name__ == "__main__":
    main()
