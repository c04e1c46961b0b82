#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A lamp or a mesh that moves with the pipeline's time, on any port: every filter answers for the time asked."""

import unittest

import numpy as np
import shadowcones as sc
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersHybrid import vtkTemporalInterpolator
from vtkmodules.vtkFiltersSources import vtkCubeSource

STEPS = (0.0, 1.0, 2.0)
HEIGHT = 2.0
PLACES = np.linspace(-7.0, 7.0, 141)


class Timed(VTKPythonAlgorithmBase):
    """Poly data of a time, offered at steps."""

    def __init__(self, make, steps=STEPS):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self.make = make
        self.steps = steps

    def RequestInformation(self, _request, _inputs, outputs):
        info = outputs.GetInformationObject(0)
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), self.steps, len(self.steps))
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), (self.steps[0], self.steps[-1]), 2)
        return 1

    def RequestData(self, _request, _inputs, outputs):
        info = outputs.GetInformationObject(0)
        key = vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()
        time = info.Get(key) if info.Has(key) else self.steps[0]
        output = vtkPolyData.GetData(outputs)
        output.ShallowCopy(self.make(time))
        output.GetInformation().Set(output.DATA_TIME_STEP(), time)
        return 1


def box(x):
    """A flat box whose middle is at x, HEIGHT above the floor."""
    cube = vtkCubeSource()
    cube.SetBounds(x - 0.5, x + 0.5, -0.5, 0.5, HEIGHT - 0.01, HEIGHT + 0.01)
    cube.Update()
    return cube.GetOutput()


def sun(slope):
    """Light that goes down and slope to the side."""
    light = sc.vtkAreaLightSource()
    light.SetShapeToSun()
    light.SetNormal(slope, 0.0, -1.0)
    light.SetAngularDiameter(0.5)
    light.Update()
    return light.GetOutput()


class Chain:
    """Every filter behind a lamp and a mesh."""

    def __init__(self, lamp, mesh):
        self.occluders = sc.vtkLabelOccluders()
        self.vectors = sc.vtkShadowVectorFilter()
        self.cones = sc.vtkConeSetFilter()
        self.probe = sc.vtkConeSetProbe()
        self.volume = sc.vtkVisibilityVolume()
        self.geometry = sc.vtkConeSetGeometry()
        self.solid = sc.vtkShadowVolume()
        self.occluders.SetInputConnection(mesh.GetOutputPort())
        self.vectors.SetInputConnection(self.occluders.GetOutputPort())
        self.vectors.SetTargetNumberOfVectors(500)
        self.vectors.SetStorageToHitPoint()
        self.cones.SetInputConnection(self.vectors.GetOutputPort())
        self.cones.SetTuningToManual()
        self.cones.SetExpansionToLightGeometry()
        self.cones.OverlapOn()
        self.cones.CosineCorrectionOff()
        line = vtkImageData()
        line.SetDimensions(PLACES.size, 1, 1)
        line.SetOrigin(PLACES[0], 0.0, 0.0)
        line.SetSpacing(PLACES[1] - PLACES[0], 1.0, 1.0)
        self.probe.SetInputData(line)
        self.probe.SetConeSetConnection(self.cones.GetOutputPort())
        self.volume.SetInputConnection(self.cones.GetOutputPort())
        self.volume.SetBounds(-7.0, 7.0, -0.4, 0.4, 0.0, 2.5)
        self.volume.SetDimensions(PLACES.size, 3, 3)
        self.volume.SetNumberOfLightSamples(4)
        for one in (self.probe, self.volume):
            one.SetMeshConnection(self.occluders.GetOutputPort())
        for one in (self.vectors, self.probe, self.volume):
            one.SetLightConnection(lamp.GetOutputPort())
        for one in (self.geometry, self.solid):
            one.SetInputConnection(self.cones.GetOutputPort())
        self.solid.SetResolution(24)
        self.solid.SetBounds(-7.0, 7.0, -2.0, 2.0, 0.0, 2.2)
        self.geometry.SetCutToPlane()
        self.geometry.SetPlaneOrigin(0.0, 0.0, 0.0)
        self.geometry.SetPlaneNormal(0.0, 0.0, 1.0)

    def filters(self):
        return (self.occluders, self.vectors, self.cones, self.probe, self.volume, self.geometry, self.solid)

    def shadows(self, time):
        """Where the shadow's middle falls on the floor, as each of the filters has it."""
        self.vectors.UpdateTimeStep(time)
        output = self.vectors.GetOutput(0)
        place = vtk_to_numpy(output.GetPoints().GetData()).mean(axis=0)
        way = vtk_to_numpy(output.GetPointData().GetArray("Direction")).mean(axis=0)
        yield "vectors", place[0] - way[0] / way[2] * place[2]
        self.probe.UpdateTimeStep(time)
        visible = vtk_to_numpy(self.probe.GetOutput().GetPointData().GetArray("Visibility"))
        yield "probe", PLACES[visible < 0.5].mean()
        self.volume.UpdateTimeStep(time)
        values = vtk_to_numpy(self.volume.GetOutput().GetPointData().GetArray("Visibility"))
        yield "volume", PLACES[values.reshape(3, 3, -1)[0, 1] < 0.5].mean()
        for name, one in (("geometry", self.geometry), ("solid", self.solid)):
            one.UpdateTimeStep(time)
            points = vtk_to_numpy(one.GetOutput().GetPoints().GetData())
            yield name, points[points[:, 2] < 0.2, 0].mean()


class Time(unittest.TestCase):
    def check(self, lamp, mesh, where, times):
        chain = Chain(lamp, mesh)
        for one in chain.filters():
            one.UpdateInformation()
            info = one.GetOutputInformation(0)
            moving = isinstance(lamp, Timed) and one is not chain.occluders or not isinstance(mesh, vtkCubeSource)
            self.assertEqual(info.Has(vtkStreamingDemandDrivenPipeline.TIME_RANGE()), int(moving), one.GetClassName())
        for time in times:
            for name, x in chain.shadows(time):
                self.assertAlmostEqual(x, where(time), delta=0.4, msg=f"{name} at {time}")
            for one in chain.filters()[1:]:
                one.UpdateTimeStep(time)
                output = one.GetOutputDataObject(0)
                self.assertEqual(output.GetInformation().Get(output.DATA_TIME_STEP()), time, one.GetClassName())

    def test_a_lamp_that_moves(self):
        mesh = vtkCubeSource()
        mesh.SetBounds(-0.5, 0.5, -0.5, 0.5, HEIGHT - 0.01, HEIGHT + 0.01)
        self.check(Timed(lambda time: sun(-time)), mesh, lambda time: -HEIGHT * time, (2.0, 0.0))

    def test_a_mesh_that_moves_between_its_steps(self):
        mesh = vtkTemporalInterpolator()  # offers a range and no steps
        source = Timed(lambda time: box(2.0 * time))
        mesh.SetInputConnection(source.GetOutputPort())
        lamp = sc.vtkAreaLightSource()
        lamp.SetShapeToSun()
        lamp.SetNormal(0.0, 0.0, -1.0)
        self.check(lamp, mesh, lambda time: 2.0 * time, (0.5, 1.75))

    def test_both_at_steps_of_their_own(self):
        lamp = Timed(lambda time: sun(-time), (0.0, 0.5, 2.0))
        mesh = Timed(box, (0.0, 1.0, 2.0))
        chain = Chain(lamp, mesh)
        chain.volume.UpdateInformation()
        info = chain.volume.GetOutputInformation(0)
        self.assertEqual(info.Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()), (0.0, 0.5, 1.0, 2.0))
        self.assertEqual(info.Get(vtkStreamingDemandDrivenPipeline.TIME_RANGE()), (0.0, 2.0))


if __name__ == "__main__":
    unittest.main()
