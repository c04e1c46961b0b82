#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Processes that share the work of one image, mpirun -np 2 python3 ranks.py: each has its tile, and the first one joins them.

Without mpirun, or without mpi4py, one process does it all, to the same bytes.
"""

import os

try:
    from mpi4py import MPI  # before VTK's, which uses what this has begun
    from vtkmodules.vtkParallelMPI import vtkMPIController

    COMM = MPI.COMM_WORLD
except ImportError:
    COMM = None

import common
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.vtkParallelCore import vtkMultiProcessController


def chain(arguments):
    """From the chair to an image by way of a grid."""
    occluders = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))
    room = scenes.put_in_room(occluders, arguments.data)
    light = scenes.ceiling_light()
    vectors = common.shadow_vectors(occluders, light, arguments.vectors)
    cones = common.cone_set(vectors)
    cones.SetTuningToAutomatic()
    volume = sc.vtkVisibilityVolume()
    volume.SetInputConnection(cones.GetOutputPort())
    volume.SetMeshConnection(occluders.GetOutputPort())
    volume.SetLightConnection(light.GetOutputPort())
    volume.SetBounds(*scenes.MEDIUM_BOUNDS)  # those of the data would be looked for by each process alone
    image = common.light_shafts(room, light, None, "Volume", arguments.size)
    image.SetVisibilityVolumeConnection(volume.GetOutputPort())
    return image


def main():
    arguments = common.parse(common.parser(__doc__, size=256, vectors=5800))
    rank, size = 0, 1
    if COMM:
        controller = vtkMPIController()
        controller.Initialize()
        vtkMultiProcessController.SetGlobalController(controller)
        rank, size = COMM.Get_rank(), COMM.Get_size()
    image = chain(arguments)
    image.UpdatePiece(rank, size, 0)

    tile = image.GetOutput()
    mine = (tile.GetExtent(), common.array(tile.GetPointData(), "RGB").copy(), sc.vtkRankWork.GetNumberOfItems(),
            sc.vtkRankWork.GetBytesSent())
    tiles = COMM.gather(mine) if COMM else [mine]
    if rank == 0:
        whole = np.zeros((arguments.size, arguments.size, 3), dtype=np.uint8)
        for k, (extent, colors, items, sent) in enumerate(tiles):
            rows, columns = extent[3] - extent[2] + 1, extent[1] - extent[0] + 1
            whole[extent[2]:extent[3] + 1, extent[0]:extent[1] + 1] = colors.reshape(rows, columns, 3)
            print(f"process {k} of {size}: {columns} x {rows} pixels, {items} shared items, {sent} bytes sent")
        common.save(whole, os.path.join(arguments.output, "ranks.png"))
    if COMM:
        vtkMultiProcessController.SetGlobalController(None)


if __name__ == "__main__":
    main()
