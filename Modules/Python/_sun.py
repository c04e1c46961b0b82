# SPDX-License-Identifier: BSD-3-Clause
"""How long the Sun shines on something."""

from . import _classes as sc
from . import _meshes, _run
from ._places import Places


def sun_hours(where, mesh, latitude, longitude, start, end, step=10, up=(0, 0, 1), north=(0, 1, 0), *, normals=None,
              cells=False, diameter=0.533, samples=64, minimum_altitude=0.0, seed=1, progress=None):
    """How many hours the Sun is seen between two times, past a mesh and above the horizon.

    Args:
        where: an (n, 3) array of points, one point, or a data set (or its path).
        mesh: what casts the shadow: a path, any VTK data set, (points, faces) arrays, or a list or dictionary of these.
        latitude, longitude: degrees, north and east are positive.
        start, end: ISO 8601, as "2024-06-21" or "2024-06-21T12:00+02:00", or datetime; without a zone UTC.
        step: minutes.
        up, north: directions in the scene.
        normals: of an array of points, if they lie on surfaces: one vector, or one a point, (n, 3).
        cells: ask at the centres of a data set's cells and not at its points.
        diameter: the angle under which the Sun is seen, degrees; 0 is a hard Sun and quicker.
        samples: of the Sun's disc, for each point and step.
        minimum_altitude: degrees, above which the Sun counts.
        seed, progress: as in visibility().

    Returns:
        for an array float32 (n,), hours; for a data set a new one of its kind with "SunHours", "FirstSun", "LastSun",
        "LongestSun" and "SunHoursError" (h).

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given. KeyboardInterrupt: on Ctrl-C.

    Example:
        >>> import shadowcones as sc
        >>> wall = ([[-99, 1, 0], [99, 1, 0], [99, 1, 9], [-99, 1, 9]], [[0, 1, 2, 3]])  # to the north
        >>> hours = sc.sun_hours([0, 0, 0], wall, 48.0, 11.0, "2024-03-20", "2024-03-21")
        >>> 11.5 < hours < 12.2
        True
    """
    places = Places(where, normals)
    path = sc.vtkSunPath()
    path.SetLatitude(latitude)
    path.SetLongitude(longitude)
    path.SetStart(iso(start))
    path.SetEnd(iso(end))
    path.SetStep(step)
    path.SetUp(*up)
    path.SetNorth(*north)
    path.SetAngularDiameter(diameter)
    occluders = _meshes.occluders_of(mesh)  # an output port does not keep its filter alive
    hours = sc.vtkSunHours()
    hours.SetInputDataObject(places.data)
    hours.SetMeshConnection(occluders.GetOutputPort())
    hours.SetPathConnection(path.GetOutputPort())
    hours.SetAssociation(hours.Cells if cells else hours.Points)
    hours.SetNumberOfLightSamples(samples)
    hours.SetMinimumAltitude(minimum_altitude)
    hours.SetSeed(seed)
    _run.update(hours, progress)
    return places.answer(hours.GetOutput(), "SunHours", cells)


def iso(time):
    """A date, a datetime or a text as ISO 8601."""
    return time.isoformat() if hasattr(time, "isoformat") else str(time)
