# SPDX-License-Identifier: BSD-3-Clause
"""Cones and solids of shadow in one line."""

from . import _classes as sc
from . import _lights, _meshes, _run, _save


def cone_set_of(mesh, light, vectors, seed):
    """The filter whose output is a proved cone set of anything that is a mesh and a light."""
    occluders = _meshes.occluders_of(mesh)
    traced = sc.vtkShadowVectorFilter()
    traced.SetInputConnection(occluders.GetOutputPort())
    traced.SetTargetNumberOfVectors(vectors)
    traced.SetSeed(seed)
    fitted = sc.vtkConeSetFilter()
    fitted.SetInputConnection(traced.GetOutputPort(0))
    fitted.SetPhotonPathConnection(traced.GetOutputPort(1))
    fitted.SetMeshConnection(occluders.GetOutputPort())
    for one in _lights.lights_of(light):
        traced.AddLightConnection(one.GetOutputPort())
        fitted.AddLightConnection(one.GetOutputPort())
    return fitted


def cones(mesh, light, *, vectors=5800, seed=1, progress=None):
    """Cones that hold the shadow of a mesh, proved: outside all of them all of the light is seen.

    Args:
        mesh: a path, any VTK data set, (points, faces) arrays, or a list or dictionary of these.
        light: words such as "sun: azimuth 135 altitude 40", a vtkAreaLightSource, a mesh that shines, or a list of these.
        vectors: how many shadow vectors the cones are fitted to; at least this many.
        seed: of the random numbers.
        progress: True for a bar, or something to call with a fraction from 0 to 1.

    Returns:
        vtkPolyData, one vertex a cone, with the arrays of vtkConeSetFilter: "Axis", "BaseRadius" (world units), "HalfAngle"
        (radians), "OccluderId", ...; field data "Certified" is 1 where the proof holds.

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given. KeyboardInterrupt: on Ctrl-C.

    Example:
        >>> import shadowcones as sc
        >>> from vtkmodules.vtkFiltersSources import vtkSphereSource
        >>> found = sc.cones(vtkSphereSource(), "disc:0,0,3 radius 0.2 facing -z", vectors=500)
        >>> found.GetFieldData().GetArray("Certified").GetValue(0)
        1
    """
    fitted = cone_set_of(mesh, light, vectors, seed)
    _run.update(fitted, progress)
    return fitted.GetOutput()


class Solids:
    """Closed surfaces around shadow: what shadow_solids() returns.

    Attributes:
        outer: vtkPolyData, around all of the shadow, penumbra and umbra.
        inner: vtkPolyData, inside the umbra.
    """

    def __init__(self, outer, inner):
        self.outer = outer
        self.inner = inner

    def save(self, path, which="outer"):
        """Write one of the two, "outer" or "inner": stl, ply, obj or vtp, by the path's extension.

        Raises ValueError for another extension, and OSError where the file cannot be written.
        """
        if which not in ("outer", "inner"):
            raise ValueError(f'which must be "outer" or "inner", not {which!r}')
        _save.save(getattr(self, which), path, _save.MESHES)

    def __repr__(self):
        return (f"<shadowcones.Solids outer {self.outer.GetNumberOfPolys()} triangles, "
                f"inner {self.inner.GetNumberOfPolys()}>")


def shadow_solids(mesh, light, *, bounds=None, resolution=64, progress=None):
    """Closed surfaces around the shadow of each occluder, fit for Booleans, clipping and measuring.

    Args:
        mesh, light, progress: as in cones().
        bounds: the box that cuts them, (x from, x to, y from, y to, z from, z to), world units. Default: they end at the
            length of the mesh's diagonal.
        resolution: cells along the longest side of a surface's grid. Faces lie where the light begins and ends to be hidden;
            edges and tips are rounded off within a cell.

    Returns:
        Solids: outer and inner (vtkPolyData, triangles, cell data "OccluderId", "LightId"), save(path).

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given. KeyboardInterrupt: on Ctrl-C.

    Example:
        >>> import shadowcones as sc
        >>> from vtkmodules.vtkFiltersSources import vtkSphereSource
        >>> solids = sc.shadow_solids(vtkSphereSource(), "point:0,0,3", resolution=16)
        >>> solids.save("shadow.stl")
    """
    occluders = _meshes.occluders_of(mesh)  # an output port does not keep its filter alive
    volume = sc.vtkShadowVolume()
    volume.SetMethodToVisibility()
    volume.SetMeshConnection(occluders.GetOutputPort())
    _lights.connect(volume, _lights.lights_of(light))
    volume.SetResolution(resolution)
    if bounds is not None:
        volume.SetBounds(*bounds)
    _run.update(volume, progress)
    return Solids(volume.GetOutput(0), volume.GetOutput(1))
