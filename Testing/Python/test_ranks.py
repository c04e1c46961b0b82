#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Two processes of MPI: a mesh that each has a part of is an error, a mesh that each has as a whole gives one answer, once."""

import sys
import unittest

try:
    from mpi4py import MPI  # before VTK's, which uses what this has begun
    from vtkmodules.vtkParallelMPI import vtkMPIController
except ImportError as missing:
    print(f"Skipped: {missing}")
    sys.exit(77)

import numpy as np
import shadowcones as sc
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkPointSource, vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController

COMM = MPI.COMM_WORLD


def ball():
    """A closed ball of radius 1."""
    sphere = vtkSphereSource()
    sphere.SetRadius(1.0)
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(16)
    sphere.Update()
    return sphere.GetOutput()


def half_of(mesh, rank):
    """Every second cell."""
    polygons = vtkCellArray()
    for cell in range(rank, mesh.GetNumberOfCells(), 2):
        polygons.InsertNextCell(mesh.GetCell(cell))
    part = vtkPolyData()
    part.SetPoints(mesh.GetPoints())
    part.SetPolys(polygons)
    return part


def gathered(part):
    """What the documentation says for programs that have no file."""
    parts = [None] * COMM.Get_size()
    for rank in range(COMM.Get_size()):
        parts[rank] = vtkPolyData()
        if rank == COMM.Get_rank():
            parts[rank].DeepCopy(part)
        CONTROLLER.Broadcast(parts[rank], rank)
    append = vtkAppendPolyData()
    for one in parts:
        append.AddInputData(one)
    append.Update()
    return append.GetOutput()


class Chain:
    """Asked for the piece of its own rank, as ParaView asks."""

    def __init__(self, mesh):
        light = sc.vtkAreaLightSource()
        light.SetShapeToDisc()
        light.SetCenter(0.0, 0.0, 5.0)
        light.SetNormal(0.0, 0.0, -1.0)
        light.SetRadius(0.5)
        self.occluders = sc.vtkLabelOccluders()
        self.occluders.SetInputData(mesh)
        self.vectors = sc.vtkShadowVectorFilter()
        self.vectors.SetInputConnection(self.occluders.GetOutputPort())
        self.vectors.SetLightConnection(light.GetOutputPort())
        self.vectors.SetNumberOfPhotons(3000)
        self.cones = sc.vtkConeSetFilter()
        self.cones.SetInputConnection(self.vectors.GetOutputPort())
        self.cones.SetTuningToManual()
        self.cones.OverlapOn()
        places = vtkPointSource()  # every process asks at points of its own
        places.SetNumberOfPoints(50)
        places.SetRadius(0.05)
        places.SetCenter(0.0, 0.0, -1.2 - 0.1 * COMM.Get_rank())
        self.probe = sc.vtkConeSetProbe()
        places.Update()
        self.probe.SetInputData(places.GetOutput())
        self.probe.SetConeSetConnection(self.cones.GetOutputPort())
        self.probe.SetMeshConnection(self.occluders.GetOutputPort())
        self.probe.SetLightConnection(light.GetOutputPort())

    def run(self, one):
        """The output of a filter for this process, and what it said."""
        said = []

        def hear(_caller, _event, text=""):
            said.append(text)

        hear.CallDataType = 13
        tag = one.AddObserver(vtkCommand.ErrorEvent, hear)
        silent = one.GetExecutive().AddObserver(vtkCommand.ErrorEvent, lambda *_: None)
        one.UpdatePiece(COMM.Get_rank(), COMM.Get_size(), 0)
        one.RemoveObserver(tag)
        one.GetExecutive().RemoveObserver(silent)
        return one.GetOutputDataObject(0), "".join(said)


class Ranks(unittest.TestCase):
    def test_a_part_of_a_mesh_is_an_error(self):
        chain = Chain(half_of(ball(), COMM.Get_rank()))
        for one in (chain.probe, chain.cones, chain.vectors, chain.occluders):
            _, said = chain.run(one)
            self.assertIn("is not the same in all 2 processes", said, one.GetClassName())
            self.assertIn("save the mesh to one file", said)

    def test_a_whole_mesh_gives_one_answer_once(self):
        for mesh in (ball(), gathered(half_of(ball(), COMM.Get_rank()))):
            chain = Chain(mesh)
            alone = Chain(mesh)
            for one, serial, key in ((chain.vectors, alone.vectors, "PhotonIndex"), (chain.cones, alone.cones, "BaseRadius")):
                output, said = chain.run(one)
                self.assertEqual(said, "")
                serial.Update()
                expected = vtk_to_numpy(serial.GetOutputDataObject(0).GetPointData().GetArray(key))
                own = vtk_to_numpy(output.GetPointData().GetArray(key)) if output.GetNumberOfPoints() else np.empty(0)
                joined = np.concatenate(COMM.allgather(own))
                np.testing.assert_array_equal(joined, expected)
            output, said = chain.run(chain.probe)
            self.assertEqual(said, "")
            # Right behind a ball of radius 1 the lamp of radius 0.5 is hidden.
            self.assertEqual(vtk_to_numpy(output.GetPointData().GetArray("Visibility")).max(), 0.0)

    def test_a_process_that_works_alone_waits_for_nobody(self):
        if COMM.Get_rank() == 0:
            chain = Chain(half_of(ball(), 0))
            chain.vectors.Update()
            self.assertGreater(chain.vectors.GetOutput().GetNumberOfPoints(), 0)


if __name__ == "__main__":
    CONTROLLER = vtkMPIController()
    CONTROLLER.Initialize()
    vtkMultiProcessController.SetGlobalController(CONTROLLER)
    result = unittest.main(exit=False).result
    if not result.wasSuccessful():
        COMM.Abort(1)  # the other process may wait
    vtkMultiProcessController.SetGlobalController(None)
