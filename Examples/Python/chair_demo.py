#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The whole chain on a slatted chair: shadow vectors, cones, light shafts, and pictures of both."""

import argparse
import os
import time

import common
import scenes
import shadowcones as sc
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import vtkCamera


class Stage:
    """Print one line with the seconds that a block took."""

    def __init__(self, name):
        self.name = name

    def __enter__(self):
        self.start = time.perf_counter()

    def __exit__(self, kind, value, trace):
        if kind is None:
            print(f"{self.name:<16}{time.perf_counter() - self.start:8.2f} s", flush=True)


def write(writer, data, path):
    writer.SetInputData(data)
    writer.SetFileName(path)
    if not writer.Write():
        raise SystemExit(f"Cannot write {path}")


def require(data, what):
    """Stop where a filter gave nothing: its message stands above."""
    if data.GetNumberOfPoints() == 0:
        raise SystemExit(f"There are no {what}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", default="output", help="folder to write to (default: output)")
    parser.add_argument("--data", default=scenes.DATA, help="folder of the meshes (default: Data of this project)")
    parser.add_argument("--vectors", type=int, default=5800, help="number of shadow vectors (default: 5800)")
    parser.add_argument("--size", type=int, default=512, help="width and height of the image in pixels (default: 512)")
    parser.add_argument("--view-size", type=int, default=400, help="the same of cones.png (default: 400)")
    parser.add_argument("--no-display", action="store_true", help="leave out cones.png, which needs a display")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)

    def path(name):
        return os.path.join(arguments.output, name)

    with Stage("Occluders"):
        light = scenes.ceiling_light()
        occluders = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))
        room = scenes.put_in_room(occluders, arguments.data)
        room.Update()

    with Stage("Shadow vectors"):
        vectors = sc.vtkShadowVectorFilter()
        vectors.SetInputConnection(room.GetOutputPort())
        vectors.SetLightConnection(light.GetOutputPort())
        vectors.SetTargetNumberOfVectors(arguments.vectors)
        vectors.SetSeed(1)
        vectors.Update()
        require(vectors.GetOutput(), "shadow vectors")
        write(vtkXMLPolyDataWriter(), vectors.GetOutput(), path("shadow-vectors.vtp"))

    with Stage("Cones"):
        cones = sc.vtkConeSetFilter()
        cones.SetInputConnection(vectors.GetOutputPort(0))
        cones.SetPhotonPathConnection(vectors.GetOutputPort(1))
        cones.SetMeshConnection(occluders.GetOutputPort())  # so the set is proved to hold all of the shadow
        cones.Update()
        require(cones.GetOutput(), "cones")
        write(vtkXMLPolyDataWriter(), cones.GetOutput(), path("cone-set.vtp"))

    with Stage("Light shafts"):
        image = sc.vtkScatteringImageFilter()
        image.SetInputConnection(room.GetOutputPort())
        image.SetLightConnection(light.GetOutputPort())
        image.SetConeSetConnection(cones.GetOutputPort())
        image.SetCamera(scenes.front_camera())
        image.SetResolution(arguments.size, arguments.size)
        image.SetModeToGuided()
        image.SetRelativeErrorGoal(0.02)  # of each pixel: sampling stops there
        image.SetToneCurveToFilmic()  # so that the lamp and the wall beside it are not cut to white
        image.SetSigmaS(0.12)
        image.SetSigmaA(0.0)
        image.SetMediumBounds(*scenes.MEDIUM_BOUNDS)
        image.Update()
        require(image.GetOutput(), "pixels")
        write(vtkXMLImageDataWriter(), image.GetOutput(), path("scattering.vti"))
        scenes.write_png(image.GetOutput(), path("scattering.png"))

    files = ["shadow-vectors.vtp", "cone-set.vtp", "scattering.vti", "scattering.png"]
    if not arguments.no_display:
        with Stage("View of cones"):
            camera = vtkCamera()
            camera.SetPosition(6.0, 3.4, 8.5)
            camera.SetFocalPoint(0.0, 0.95, 0.0)
            camera.SetViewAngle(29.0)
            common.save(common.cone_view(occluders, vectors, cones, 0.8, camera, arguments.view_size, 0.5),
                        path("cones.png"))
        files.append("cones.png")

    def figure(data, name):
        return data.GetFieldData().GetArray(name).GetTuple1(0)

    photons = figure(vectors.GetOutput(), "NumberOfPhotons")
    proved = "proved to hold all of the shadow" if figure(cones.GetOutput(), "Certified") else "not proved"
    rays = figure(image.GetOutput(), "NumberOfOcclusionRays")
    print(f"""
VTK {vtkVersion.GetVTKVersion()}, ShadowCones {sc.__version__}
shadow vectors  {vectors.GetOutput().GetNumberOfPoints():10,}  from {photons:,.0f} photons
cones           {cones.GetOutput().GetNumberOfPoints():10,}  {proved}
occlusion rays  {rays:10,.0f}  for {arguments.size} x {arguments.size} pixels
written to {arguments.output}: {', '.join(files)}""")


if __name__ == "__main__":
    main()
