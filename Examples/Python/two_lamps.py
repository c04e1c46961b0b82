#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A chair under a warm and a cool lamp in fog: the light of both, of each alone, and the share of each on the floor."""

import os

import common
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkPlaneSource

# Radiance at seven wavelengths from blue to red.
WARM = (60, 90, 120, 150, 180, 210, 240)
COOL = (240, 210, 180, 150, 120, 90, 60)


def lamp(x, spectrum):
    """A small disc under the ceiling, facing down."""
    light = sc.vtkAreaLightSource()
    light.SetShapeToDisc()
    light.SetCenter(x, 5.4, 0.0)
    light.SetNormal(0.0, -1.0, 0.0)
    light.SetRadius(0.25)
    for index, radiance in enumerate(spectrum):
        light.SetRadianceSpectrum(index, radiance)
    return light


def connect(consumer, lights):
    """Every light is one connection: the k-th has the LightId k."""
    consumer.RemoveAllLights()
    for light in lights:
        consumer.AddLightConnection(light.GetOutputPort())


def bounds_of_shadow(occluders, lights, number):
    """One cone set for all lights: a cone never joins vectors of two."""
    vectors = sc.vtkShadowVectorFilter()
    vectors.SetInputConnection(occluders.GetOutputPort())
    connect(vectors, lights)
    vectors.SetTargetNumberOfVectors(number)
    vectors.SetStorageToHitPoint()
    cones = sc.vtkConeSetFilter()
    cones.SetInputConnection(vectors.GetOutputPort(0))
    cones.SetPhotonPathConnection(vectors.GetOutputPort(1))
    cones.SetTuningToConservative()
    cones.Update()
    return cones


def floor_shares(occluders, lights, cones):
    """What of each lamp is seen on the floor, a column a lamp."""
    floor = vtkPlaneSource()
    floor.SetOrigin(-2.7, 0.01, -2.7)
    floor.SetPoint1(-2.7, 0.01, 2.7)
    floor.SetPoint2(2.7, 0.01, -2.7)
    floor.SetResolution(60, 60)
    probe = sc.vtkConeSetProbe()
    probe.SetInputConnection(floor.GetOutputPort())
    probe.SetConeSetConnection(cones.GetOutputPort())
    probe.SetMeshConnection(occluders.GetOutputPort())
    connect(probe, lights)
    probe.Update()
    return common.array(probe.GetOutput().GetPointData(), "Visibility")


def main():
    arguments = common.parse(common.parser(__doc__, size=480, vectors=6000))
    occluders = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))
    room = scenes.put_in_room(occluders, arguments.data)
    lights = [lamp(-1.6, WARM), lamp(1.6, COOL)]
    cones = bounds_of_shadow(occluders, lights, arguments.vectors)
    light_ids = common.array(cones.GetOutput().GetPointData(), "LightId")
    print(f"{np.sum(light_ids == 0)} cones of the warm lamp, {np.sum(light_ids == 1)} of the cool one")
    shares = floor_shares(occluders, lights, cones)
    hidden = shares < 1
    print(f"of the floor {np.mean(hidden[:, 0]):.1%} lie in shadow of the warm lamp, {np.mean(hidden[:, 1]):.1%} of "
          f"the cool one, {np.mean(hidden.all(axis=1)):.1%} of both")

    image = common.light_shafts(room, lights[0], cones, "Guided", arguments.size)
    image.SetToneCurveToFilmic()
    image.SetRelativeErrorGoal(0.02)
    titles, pictures = ("both", "warm", "cool"), []
    for chosen in (lights, lights[:1], lights[1:]):
        connect(image, chosen)
        image.Update()
        pictures.append(common.pixels(image.GetOutput()).copy())
    common.save(common.table([pictures], titles), os.path.join(arguments.output, "two-lamps.png"))


if __name__ == "__main__":
    main()
