#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The five shapes of vtkAreaLightSource over the same blob in fog: what the shape does to the shadow."""

import math
import os

import common
import scenes
import shadowcones as sc
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource

CENTER = (0.0, 5.49, 0.0)
IRRADIANCE = 6.0  # W m^-2 on the blob, straight below, for every shape
DISTANCE = 3.0


def lights():
    """Name and light, each as bright on the blob as the others."""
    disc = sc.vtkAreaLightSource()
    disc.SetShapeToDisc()
    disc.SetCenter(*CENTER)
    disc.SetNormal(0.0, -1.0, 0.0)
    disc.SetRadius(0.5)
    disc.SetRadiance(IRRADIANCE * DISTANCE**2 / (math.pi * 0.5**2))
    yield "disc", disc

    rectangle = sc.vtkAreaLightSource()
    rectangle.SetShapeToRectangle()
    rectangle.SetCenter(*CENTER)
    rectangle.SetNormal(0.0, -1.0, 0.0)
    rectangle.SetUp(0.0, 0.0, -1.0)
    rectangle.SetWidth(3.0)
    rectangle.SetHeight(0.2)
    rectangle.SetRadiance(IRRADIANCE * DISTANCE**2 / (3.0 * 0.2))
    yield "rectangle", rectangle

    sphere = sc.vtkAreaLightSource()
    sphere.SetShapeToSphere()
    sphere.SetCenter(0.0, 4.9, 0.0)
    sphere.SetRadius(0.3)
    sphere.SetRadiance(IRRADIANCE * (DISTANCE - 0.59)**2 / (math.pi * 0.3**2))
    yield "sphere", sphere

    point = sc.vtkAreaLightSource()
    point.SetShapeToPoint()
    point.SetCenter(*CENTER)
    point.SetRadiance(IRRADIANCE * DISTANCE**2)  # W sr^-1
    yield "point", point

    sun = sc.vtkAreaLightSource()
    sun.SetShapeToSun()
    sun.SetCenter(*CENTER)
    sun.SetNormal(0.45, -1.0, 0.0)
    sun.SetAngularDiameter(0.533)
    sun.SetRadiance(IRRADIANCE)  # W m^-2
    yield "sun", sun


def floor():
    """A square that catches shadows and casts none; a room's ceiling would keep the sun out."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-2.75, 0.0, 2.75)
    plane.SetPoint1(2.75, 0.0, 2.75)
    plane.SetPoint2(-2.75, 0.0, -2.75)
    plane.Update()
    result = plane.GetOutput()
    scenes.set_reflectance(result, 0.35)
    return common.receivers(result)


def main():
    arguments = common.parse(common.parser(__doc__, size=320))
    blob = scenes.label(scenes.read(os.path.join(arguments.data, "blob.vtp")))
    scene = vtkAppendPolyData()
    scene.AddInputConnection(blob.GetOutputPort())
    scene.AddInputData(floor())

    names, pictures = [], []
    for name, light in lights():
        image = sc.vtkScatteringImageFilter()
        image.SetInputConnection(scene.GetOutputPort())
        image.SetLightConnection(light.GetOutputPort())
        image.SetCamera(scenes.front_camera())
        image.SetResolution(arguments.size, arguments.size)
        image.SetModeToBruteForce()
        image.SetToneCurveToFilmic()
        image.SetSigmaS(0.25)
        image.SetPhasePresetToRayleigh()
        image.SetMediumBounds(-2.75, 2.75, 0.0, 5.5, -2.75, 2.75)
        image.SetNumberOfSurfaceLightSamples(32)
        image.Update()
        spectrum = common.array(light.GetOutput().GetFieldData(), "LightSpectrum")
        print(f"{name}: {light.GetOutput().GetNumberOfPoints()} points, "
              f"{len(spectrum)} wavelengths of {spectrum[0]:.1f}", flush=True)
        names.append(name)
        pictures.append(common.pixels(image.GetOutput()))
    common.save(common.table([pictures], names), os.path.join(arguments.output, "lights.png"))


if __name__ == "__main__":
    main()
