#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Several processes of MPI share the work and get the bytes of one; a mesh that each has a part of is an error."""

import hashlib
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
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkPointSource, vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.vtkRenderingCore import vtkCamera

COMM = MPI.COMM_WORLD


def ball():
    """A closed ball of radius 1."""
    sphere = vtkSphereSource()
    sphere.SetRadius(1.0)
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(16)
    sphere.Update()
    return sphere.GetOutput()


def part_of(mesh, rank):
    """The cells of one process, if every one has as many."""
    polygons = vtkCellArray()
    for cell in range(rank, mesh.GetNumberOfCells(), COMM.Get_size()):
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


def bytes_of(data):
    """A hash of the points, cells and arrays of a data set."""
    digest = hashlib.sha256()
    if data.IsA("vtkPolyData"):
        if data.GetNumberOfPoints():
            digest.update(vtk_to_numpy(data.GetPoints().GetData()).tobytes())
        for cells in (data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()):
            digest.update(vtk_to_numpy(cells.GetConnectivityArray()).tobytes())
    else:
        digest.update(repr((data.GetExtent(), data.GetOrigin(), data.GetSpacing())).encode())
    for arrays in (data.GetPointData(), data.GetCellData(), data.GetFieldData()):
        for k in range(arrays.GetNumberOfArrays()):
            array = arrays.GetAbstractArray(k)
            digest.update(array.GetName().encode())
            if array.IsA("vtkDataArray"):
                digest.update(vtk_to_numpy(array).tobytes())
            else:
                digest.update("".join(array.GetValue(i) for i in range(array.GetNumberOfValues())).encode())
    return digest.hexdigest()


def shares(count):
    """The part of this process among all, of something that each counts for itself."""
    return count / max(1, sum(COMM.allgather(count)))


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
        self.light = light
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
        speakers = {one, self.occluders, self.vectors, self.cones, self.probe}
        tags = [(speaker, speaker.AddObserver(vtkCommand.ErrorEvent, hear)) for speaker in speakers]
        silent = one.GetExecutive().AddObserver(vtkCommand.ErrorEvent, lambda *_: None)
        one.UpdatePiece(COMM.Get_rank(), COMM.Get_size(), 0)
        for speaker, tag in tags:
            speaker.RemoveObserver(tag)
        one.GetExecutive().RemoveObserver(silent)
        return one.GetOutputDataObject(0), "".join(said)


class Answers(Chain):
    """What is behind the chain: a grid, an image, and questions at points that every process has."""

    def __init__(self, mesh):
        super().__init__(mesh)
        self.vectors.SetTargetNumberOfVectors(3000)
        self.cones.OverlapOff()
        self.cones.SetTuningToConservative()
        self.cones.SetPhotonPathConnection(self.vectors.GetOutputPort(1))
        self.volume = sc.vtkVisibilityVolume()
        self.volume.SetInputConnection(self.cones.GetOutputPort())
        self.volume.SetMeshConnection(self.occluders.GetOutputPort())
        self.volume.SetLightConnection(self.light.GetOutputPort())
        self.volume.SetDimensions(17, 17, 17)
        self.volume.SetBounds(-2, 2, -2, 2, -3, 1)
        self.volume.SetNumberOfLightSamples(16)
        camera = vtkCamera()
        camera.SetPosition(0, -9, 0)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        self.image = sc.vtkScatteringImageFilter()
        self.image.SetInputConnection(self.occluders.GetOutputPort())
        self.image.SetLightConnection(self.light.GetOutputPort())
        self.image.SetVisibilityVolumeConnection(self.volume.GetOutputPort())
        self.image.SetCamera(camera)
        self.image.SetResolution(24, 24)
        self.image.SetModeToVolume()
        self.image.SetMediumBounds(-2, 2, -2, 2, -3, 1)
        self.image.SetAutoExposure(False)
        ground = vtkPlaneSource()
        ground.SetOrigin(-3, -3, -2)
        ground.SetPoint1(3, -3, -2)
        ground.SetPoint2(-3, 3, -2)
        ground.SetResolution(30, 30)
        ground.Update()
        self.probe.SetInputData(ground.GetOutput())
        path = sc.vtkSunPath()
        path.SetLatitude(45)
        path.SetStart("2026-06-21T06:00")
        path.SetEnd("2026-06-21T18:00")
        path.SetStep(60)
        self.hours = sc.vtkSunHours()
        self.hours.SetInputData(ground.GetOutput())
        self.hours.SetMeshConnection(self.occluders.GetOutputPort())
        self.hours.SetPathConnection(path.GetOutputPort())
        self.widths = sc.vtkPenumbraWidth()
        self.widths.SetInputData(ground.GetOutput())
        self.widths.SetMeshConnection(self.occluders.GetOutputPort())
        self.widths.SetLightConnection(self.light.GetOutputPort())
        self.widths.SetNumberOfLightSamples(32)


class Ranks(unittest.TestCase):
    def test_a_part_of_a_mesh_is_an_error(self):
        if COMM.Get_size() == 1:
            return
        chain = Chain(part_of(ball(), COMM.Get_rank()))
        for one in (chain.probe, chain.cones, chain.vectors, chain.occluders):
            _, said = chain.run(one)
            self.assertIn(f"is not the same in all {COMM.Get_size()} processes", said, one.GetClassName())
            self.assertIn("save the mesh to one file", said)

    def test_a_whole_mesh_gives_one_answer_once(self):
        for mesh in (ball(), gathered(part_of(ball(), COMM.Get_rank()))):
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

    def test_work_that_is_shared_gives_the_bytes_of_one_process(self):
        mesh = ball()
        alone = Answers(mesh)
        vtkMultiProcessController.SetGlobalController(None)
        for one in (alone.image, alone.probe, alone.hours, alone.widths):
            one.Update()
        vtkMultiProcessController.SetGlobalController(CONTROLLER)
        together = Answers(mesh)
        size = COMM.Get_size()
        sc.vtkRankWork.Reset()
        output, said = together.run(together.image)
        self.assertEqual(said, "")
        for one, serial in ((together.vectors, alone.vectors), (together.cones, alone.cones), (together.volume, alone.volume)):
            for port in range(one.GetNumberOfOutputPorts()):
                self.assertEqual(bytes_of(one.GetOutputDataObject(port)), bytes_of(serial.GetOutputDataObject(port)),
                                 f"{one.GetClassName()}, port {port}")
        if size > 1:
            self.assertAlmostEqual(shares(sc.vtkRankWork.GetNumberOfItems()), 1.0 / size, delta=0.1)
            self.assertGreater(sc.vtkRankWork.GetBytesReceived(), 0)
            rays = sc.vtkRankWork.GetNumberOfRays() - together.image.GetNumberOfRaysSent()  # of the grid
            self.assertAlmostEqual(shares(rays), 1.0 / size, delta=0.06)
        # Pixels: each process has its own.
        low_x, high_x, low_y, high_y = output.GetExtent()[:4]
        for name in ("Radiance", "InScattering", "Depth"):
            part = vtk_to_numpy(output.GetPointData().GetArray(name)).reshape(high_y - low_y + 1, high_x - low_x + 1, -1)
            whole = vtk_to_numpy(alone.image.GetOutput().GetPointData().GetArray(name)).reshape(24, 24, -1)
            np.testing.assert_array_equal(part, whole[low_y:high_y + 1, low_x:high_x + 1])
        # Tiles share the pixels on their edges, as all extents of VTK do.
        tiles = COMM.allgather(part.shape[0] * part.shape[1])
        self.assertGreaterEqual(sum(tiles), 24 * 24)
        self.assertLessEqual(max(tiles), 25 * 24 // size + 24)
        # Points that all have: all get all answers.
        for one, serial in ((together.probe, alone.probe), (together.hours, alone.hours), (together.widths, alone.widths)):
            sc.vtkRankWork.Reset()
            output, said = together.run(one)
            self.assertEqual(said, "")
            self.assertEqual(bytes_of(output), bytes_of(serial.GetOutputDataObject(0)), one.GetClassName())
            if size > 1:
                self.assertAlmostEqual(shares(sc.vtkRankWork.GetNumberOfItems()), 1.0 / size, delta=0.1)

    def test_a_failure_in_one_process_ends_all(self):
        chain = Chain(ball())
        if COMM.Get_rank() == 0:
            chain.vectors.SetNumberOfPhotons(-1)
        output, said = chain.run(chain.cones)
        self.assertEqual(output.GetNumberOfPoints(), 0)
        self.assertEqual(chain.vectors.GetOutput().GetNumberOfPoints(), 0)
        self.assertIn("must be 0 or more" if COMM.Get_rank() == 0 else "process 0 of", said.replace("Process", "process"))
        chain.vectors.SetNumberOfPhotons(3000)
        output, said = chain.run(chain.cones)
        self.assertEqual(said, "")
        self.assertGreater(sum(COMM.allgather(output.GetNumberOfPoints())), 0)

    def test_a_process_that_works_alone_waits_for_nobody(self):
        if COMM.Get_rank() == 0:
            chain = Chain(part_of(ball(), 0))
            chain.vectors.Update()
            self.assertGreater(chain.vectors.GetOutput().GetNumberOfPoints(), 0)
        # What stands already in one process is not asked of the others together.
        chain = Chain(ball())
        if COMM.Get_rank() == 0:
            chain.vectors.Update()
        _, said = chain.run(chain.cones)
        self.assertEqual(said, "")
        first = chain.vectors.GetOutput().GetNumberOfPoints()
        self.assertEqual(COMM.allgather(first), [first] * COMM.Get_size())
        if COMM.Get_rank() == 0:
            chain.vectors.SetSeed(2)
            chain.vectors.Update()


if __name__ == "__main__":
    CONTROLLER = vtkMPIController()
    CONTROLLER.Initialize()
    vtkMultiProcessController.SetGlobalController(CONTROLLER)
    result = unittest.main(exit=False).result
    if not result.wasSuccessful():
        COMM.Abort(1)  # the other process may wait
    vtkMultiProcessController.SetGlobalController(None)
