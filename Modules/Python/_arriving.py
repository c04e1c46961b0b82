# SPDX-License-Identifier: BSD-3-Clause
"""How much light arrives: on a surface, and at a point from all around."""

import numpy as np

from . import _run
from ._answers import probe_of
from ._places import Places


def per_wavelength(values, places):
    """(n, wavelengths) also where there is one wavelength."""
    if not places.is_array or places.single or values.ndim == 2:
        return np.atleast_1d(values) if places.single else values
    return values[:, np.newaxis]


def irradiance(where, mesh, light, *, normals=None, cells=False, samples=64, seed=1, progress=None):
    """How much light falls on a surface, W m^-2 in each wavelength, of all lights together.

    Args:
        where: an (n, 3) array of points, one point, or a data set (or its path), with active normals.
        mesh: what casts the shadow: a path, any VTK data set, (points, faces) arrays, or a list or dictionary of these.
        light: words such as "disc:0,5,0 radius 0.5 facing -y flux 800 lm", a vtkAreaLightSource, a mesh that shines, or a
            list of these.
        normals: of an array of points: one vector, or one a point, (n, 3); the side on which the light falls.
        cells: ask at the centres of a data set's cells and not at its points.
        samples: of each light, for each point.
        seed: of the random numbers.
        progress: True for a bar, or something to call with a fraction from 0 to 1.

    Returns:
        for an array float32 (n, wavelengths); for a data set a new one of its kind with "Irradiance", "IrradianceError" (one
        standard error) and the arrays of visibility(). Coordinates count as metres where a point light's are divided by.

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given. KeyboardInterrupt: on Ctrl-C.

    Example:
        >>> import shadowcones as sc
        >>> plate = ([[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], [[0, 1, 2, 3]])
        >>> lamp = "point:0,0,2 radiance 8"  # W sr^-1 at each of seven wavelengths
        >>> sc.irradiance([[0, 0, 0], [4, 0, 2]], plate, lamp, normals=[[0, 0, 1], [-1, 0, 0]])[:, 0].tolist()
        [0.0, 0.5]
    """
    places = Places(where, normals)
    if places.is_array and normals is None:
        raise ValueError("normals are needed beside an array of points: one vector, or one a point")
    probe = probe_of(places, mesh, light, cells, samples, seed)
    probe.ComputeIrradianceOn()
    _run.update(probe, progress)
    return per_wavelength(places.answer(probe.GetOutput(), "Irradiance", cells), places)


def fluence(where, mesh, light, *, cells=False, samples=64, seed=1, progress=None):
    """How much light passes a point from all directions, the fluence rate, W m^-2 in each wavelength, of all lights together.

    Args:
        where, mesh, light, cells, samples, seed, progress: as in irradiance(); no normals.

    Returns:
        for an array float32 (n, wavelengths); for a data set a new one of its kind with "FluenceRate", "FluenceRateError" (one
        standard error) and the arrays of visibility().

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given. KeyboardInterrupt: on Ctrl-C.

    Example:
        >>> import shadowcones as sc
        >>> pillar = ([[-1, 0, 0], [1, 0, 0], [1, 0, 9], [-1, 0, 9]], [[0, 1, 2, 3]])
        >>> sc.fluence([[0, 2, 1], [5, 2, 1]], pillar, "point:0,-2,1 radiance 41").round(4)[:, 0].tolist()
        [0.0, 1.0]
    """
    places = Places(where)
    probe = probe_of(places, mesh, light, cells, samples, seed)
    probe.ComputeFluenceRateOn()
    probe.UseNormalsOff()
    _run.update(probe, progress)
    return per_wavelength(places.answer(probe.GetOutput(), "FluenceRate", cells), places)
