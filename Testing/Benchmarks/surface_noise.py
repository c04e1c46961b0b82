#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Noise of surfaces in the scattering image: seconds of a frame, error against a converged one, and error claims."""

import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
import scenes  # noqa: E402
import shadowcones as sc  # noqa: E402

EXTINCTION = 0.12


def read(scene):
    """A mesh of Data/, or of an .obj file, which is made three high and put on the floor."""
    if not scene.endswith(".obj"):
        return scenes.read(os.path.join(scenes.DATA, scene + ".vtp"))
    reader = vtkOBJReader()
    reader.SetFileName(scene)
    reader.Update()
    bounds = reader.GetOutput().GetBounds()
    transform = vtkTransform()
    scale = 3.0 / (bounds[3] - bounds[2])
    transform.Scale(scale, scale, scale)
    transform.Translate(-0.5 * (bounds[0] + bounds[1]), -bounds[2], -0.5 * (bounds[4] + bounds[5]))
    stand = vtkTransformPolyDataFilter()
    stand.SetInputData(reader.GetOutput())
    stand.SetTransform(transform)
    stand.Update()
    stand.GetOutput().GetPointData().Initialize()  # facets, as every scene here
    return stand.GetOutput()


def image_of(scene):
    """The image filter of a scene, with its chain."""
    light = scenes.ceiling_light()
    occluders = scenes.label(read(scene))
    room = scenes.put_in_room(occluders)
    vectors = sc.vtkShadowVectorFilter()
    vectors.SetInputConnection(room.GetOutputPort())
    vectors.SetLightConnection(light.GetOutputPort())
    vectors.SetTargetNumberOfVectors(5800)
    cones = sc.vtkConeSetFilter()
    cones.SetInputConnection(vectors.GetOutputPort(0))
    cones.SetPhotonPathConnection(vectors.GetOutputPort(1))
    cones.SetMeshConnection(occluders.GetOutputPort())
    image = sc.vtkScatteringImageFilter()
    image.SetInputConnection(room.GetOutputPort())
    image.SetLightConnection(light.GetOutputPort())
    image.SetConeSetConnection(cones.GetOutputPort())
    image.SetCamera(scenes.front_camera())
    image.SetMediumBounds(*scenes.MEDIUM_BOUNDS)
    return image


def values(image, name):
    array = vtk_to_numpy(image.GetOutput().GetPointData().GetArray(name)).astype(float)
    return array.mean(axis=1) if array.ndim > 1 else array


def field(image, name):
    return image.GetOutput().GetFieldData().GetArray(name).GetTuple1(0)


def seconds_of(image, scatters):
    """The shortest of three frames of 256 x 256; without scattering it is that of the surfaces."""
    image.SetResolution(256, 256)
    image.SetNumberOfEdgeSamples(4)
    image.SetModeToGuided()
    image.SetSigmaS(EXTINCTION if scatters else 0.0)
    image.SetSigmaA(0.0 if scatters else EXTINCTION)
    shortest = float("inf")
    for seed in (1, 2, 3):
        image.SetSeed(seed)
        image.Update()
        shortest = min(shortest, field(image, "RenderSeconds"))
    return shortest, field(image, "NumberOfOcclusionRays")


def surfaces_of(image):
    """The image of surfaces alone, 128 x 128, one ray a pixel."""
    image.SetResolution(128, 128)
    image.SetNumberOfEdgeSamples(1)
    image.SetSigmaS(0.0)
    image.SetSigmaA(EXTINCTION)
    image.Update()
    return values(image, "SurfaceRadiance"), values(image, "SurfaceRelativeError")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scenes", nargs="*", default=["chair", "tree"], help="names of Data/, or .obj files")
    arguments = parser.parse_args()
    for scene in arguments.scenes:
        image = image_of(scene)
        image.SetModeToBruteForce()
        image.SetNumberOfSurfaceLightSamples(8192)
        image.SetSeed(77)
        image.SetMaximumSamples(4096)
        truth, _ = surfaces_of(image)
        image.SetNumberOfSurfaceLightSamples(16)
        image.SetMaximumSamples(1024)
        for goal in (0.05, 0.01):
            image.SetRelativeErrorGoal(goal)
            frame, _ = seconds_of(image, True)
            surfaces, rays = seconds_of(image, False)
            image.SetMaximumSamples(16)  # a point, whatever the goal
            fixed, _ = seconds_of(image, False)
            image.SetMaximumSamples(1024)
            image.SetSeed(1)
            found, relative = surfaces_of(image)
            difference = np.abs(found - truth)
            claimed = relative * np.abs(found)
            sampled = relative > 0.2 * goal  # not only unshadowed light by quadrature
            within = [np.mean(difference[sampled] <= n * claimed[sampled]) for n in (1, 2)]
            error = np.sqrt(np.mean(difference ** 2)) / truth.mean()
            bias = (found - truth).mean() / truth.mean()
            print(f"{os.path.basename(scene)}, goal {goal}: frame {frame:.3f} s, surfaces {surfaces:.3f} s with "
                  f"{rays:,.0f} rays, {fixed:.3f} s with 16 a point; error {error:.2%}, bias {bias:+.3%}; "
                  f"within 1, 2 standard errors {within[0]:.1%}, {within[1]:.1%} of {sampled.mean():.1%}", flush=True)


if __name__ == "__main__":
    main()
