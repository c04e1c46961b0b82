# SPDX-License-Identifier: BSD-3-Clause
"""Questions at points and on surfaces: how much of a light is seen, and whose shadow it is."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import _classes as sc
from . import _lights, _meshes, _run
from ._places import Places


def probe_of(places, mesh, light, cells, samples, seed):
    """The vtkConeSetProbe that asks the mesh itself at places."""
    occluders = _meshes.occluders_of(mesh)  # an output port does not keep its filter alive
    probe = sc.vtkConeSetProbe()
    probe.SetInputDataObject(places.data)
    probe.SetMeshConnection(occluders.GetOutputPort())
    _lights.connect(probe, _lights.lights_of(light))
    probe.SetMethodToExact()
    probe.SetAssociation(probe.Cells if cells else probe.Points)
    probe.SetNumberOfLightSamples(samples)
    probe.SetSeed(seed)
    return probe


def visibility(where, mesh, light, *, cells=False, samples=64, seed=1, progress=None):
    """How much of a light is seen: 1 where all of it is (lit), 0 where nothing is (umbra), between in the penumbra.

    Args:
        where: an (n, 3) array of points, one point, or a data set (or its path).
        mesh: what casts the shadow: a path, any VTK data set, (points, faces) arrays, or a list or dictionary of these.
        light: words such as "sun: azimuth 135 altitude 40", a vtkAreaLightSource, a mesh that shines, or a list of these.
        cells: ask at the centres of a data set's cells and not at its points.
        samples: of the light, for each point: the standard error is at most 0.5 / sqrt(samples).
        seed: of the random numbers.
        progress: True for a bar, or something to call with a fraction from 0 to 1.

    Returns:
        for an array float32 (n,), of several lights (n, lights); for a data set a new one of its kind with the arrays of
        vtkConeSetProbe: "Visibility", "ShadowClass" (0 lit, 1 penumbra, 2 umbra), "OccluderId", "VisibilityError".

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given. KeyboardInterrupt: on Ctrl-C.

    Example:
        >>> import shadowcones as sc
        >>> plate = ([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2, 3]])
        >>> sc.visibility([[0, 0, -1], [5, 0, -1], [0, 0, 1]], plate, "point:0,0,4").tolist()
        [0.0, 1.0, 1.0]
    """
    places = Places(where)
    probe = probe_of(places, mesh, light, cells, samples, seed)
    _run.update(probe, progress)
    return places.answer(probe.GetOutput(), "Visibility", cells)


def names_in(output):
    """Names of occluders by id; None where they have none but their numbers."""
    array = output.GetFieldData().GetAbstractArray("OccluderNames")
    names = [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []
    return None if all(name == str(number) for number, name in enumerate(names)) else names


def shadow_of(where, mesh, light, *, cells=False, samples=64, seed=1, progress=None):
    """Whose shadow it is: the occluder that hides most of the light.

    Args:
        where, mesh, light, cells, samples, seed, progress: as in visibility().

    Returns:
        for an array: names, str (n,), where the occluders have names (files, dictionaries, blocks, ids of their own),
        "" where nothing hides the light; else numbers, int64 (n,), from 0, -1 where nothing does. Of several lights (n, lights).
        For a data set: a new one of its kind with the arrays of visibility(); names are in its field data "OccluderNames".

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given. KeyboardInterrupt: on Ctrl-C.

    Example:
        >>> import shadowcones as sc
        >>> plate = ([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2, 3]])
        >>> sc.shadow_of([[0, 0, -1], [5, 0, -1]], {"roof": plate}, "point:0,0,4").tolist()
        ['roof', '']
    """
    places = Places(where)
    probe = probe_of(places, mesh, light, cells, samples, seed)
    _run.update(probe, progress)
    output = probe.GetOutput()
    if not places.is_array:
        return places.answer(output, "OccluderId", cells)
    ids = vtk_to_numpy(output.GetPointData().GetArray("OccluderId")).astype(np.int64)
    names = names_in(output)
    answer = ids if names is None else np.array([*names, ""])[ids]  # -1 is the last one
    return answer[0] if places.single else answer
