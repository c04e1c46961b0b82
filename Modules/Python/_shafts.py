# SPDX-License-Identifier: BSD-3-Clause
"""Light shafts in one line: the image, and what it is made of."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkCamera

from . import _classes as sc
from . import _lights, _meshes, _run, _save

AXES = {"x": 1, "y": 2, "z": 3}


class Shot:
    """An image of light shafts: what light_shafts() returns.

    Attributes:
        image: vtkImageData, as vtkScatteringImageFilter gives it; its row 0 is the lowest.
        camera: the vtkCamera that it was taken with.
        lights: the lights, a list of algorithms.
    """

    def __init__(self, image, camera, lights):
        self.image = image
        self.camera = camera
        self.lights = lights

    def array(self, name):
        """A point array of the image by its name: height x width, or height x width x components; row 0 is the top one.

        Raises KeyError where there is none of that name.
        """
        values = self.image.GetPointData().GetArray(name)
        if values is None:
            raise KeyError(name)
        width, height, _ = self.image.GetDimensions()
        numbers = vtk_to_numpy(values)
        return numbers.reshape((height, width) + numbers.shape[1:])[::-1]

    @property
    def rgb(self):
        """The picture: uint8, height x width x 3, row 0 is the top one. A view of the image's memory."""
        return self.array("RGB")

    @property
    def radiance(self):
        """float32, height x width x wavelengths, W m^-2 sr^-1 in each band, row 0 is the top one. A view."""
        values = self.array("Radiance")
        return values if values.ndim == 3 else values[:, :, np.newaxis]

    def save(self, path):
        """Write the picture (png, tif, jpg, bmp), the whole image (vti) or the radiances (npy), by the path's extension.

        Raises ValueError for another extension, and OSError where the file cannot be written.
        """
        if str(path).lower().endswith(".npy"):
            np.save(path, self.radiance)
        else:
            _save.save(self.image, path, _save.IMAGES)

    def __repr__(self):
        width, height, _ = self.image.GetDimensions()
        seconds = self.image.GetFieldData().GetArray("RenderSeconds").GetTuple1(0)
        return f"<shadowcones.Shot {width} x {height}, {self.radiance.shape[2]} wavelengths, {seconds:.2f} s>"

    def _repr_png_(self):
        return _save.png(self.image)


def camera_of(camera):
    """A vtkCamera of one, of a position alone, or of (position, focal point, view up)."""
    if isinstance(camera, vtkCamera):
        return camera
    try:
        position, focal, up = camera
        made = vtkCamera()
        made.SetPosition(*map(float, position))
        made.SetFocalPoint(*map(float, focal))
        made.SetViewUp(*map(float, up))
    except (TypeError, ValueError):
        raise TypeError("camera must be a vtkCamera or (position, focal point, view up), three points each") from None
    return made


def picture_size(size):
    try:
        width, height = (int(value) for value in size)
    except (TypeError, ValueError):
        raise TypeError("size must be (width, height)") from None
    if width < 1 or height < 1:
        raise ValueError(f"size is {width} x {height}: both must be at least 1")
    return width, height


def up_axis(up):
    """0 for none, else 1, 2, 3 for x, y, z; vectors along an axis are fine."""
    if up is None:
        return 0
    if isinstance(up, str) and up.lower() in AXES:
        return AXES[up.lower()]
    vector = np.abs(np.asarray(up, dtype=float)) if not isinstance(up, str) else np.zeros(1)
    if vector.shape != (3,) or np.count_nonzero(vector) != 1:
        raise ValueError(f"up must be x, y or z, not {up!r}")
    return int(np.argmax(vector)) + 1


def defaults_of(occluders, lights, axis):
    """The vtkSceneDefaults of labelled occluders that are up to date, and lights."""
    defaults = sc.vtkSceneDefaults()
    defaults.SetUp(axis)
    defaults.SetMesh(occluders.GetOutput())
    for light in lights:
        defaults.AddLight(_run.update(light).GetOutputDataObject(0))
    if not defaults.Find():
        raise ValueError(defaults.GetError())
    return defaults


def light_shafts(mesh, light=None, camera=None, size=(640, 480), error=0.02, *, medium=None, sigma_s=None, sigma_a=0.0,
                 asymmetry=0.0, up=None, exposure=None, tone="filmic", seed=1, progress=None):
    """The light shafts that a camera sees around a mesh in a thin medium: fog, smoke, water.

    No cones are made: for one image that takes as long as they save.

    Args:
        mesh: a path (vtp, vtk, vtu, ply, stl, obj, 3ds, gltf, glb), any VTK data set, (points, faces) arrays, or a list or
            dictionary of these, one occluder each.
        light: words such as "disc:0,5,0 radius 0.5 facing 0,-1,0" (vtkLightWords has them all), a vtkAreaLightSource, a mesh
            that shines, or a list of these. Default: a disc above the mesh; in a room one under its ceiling.
        camera: a vtkCamera, or (position, focal point, view up). Default: one that sees the mesh and its medium.
        size: (width, height) in pixels.
        error: relative standard error of each pixel to reach, of the light from the medium.
        medium: the box of the medium, (x from, x to, y from, y to, z from, z to), world units. Default: around the mesh.
        sigma_s: scattering coefficient, 1 / world unit. Default: 0.7 over the medium's largest size.
        sigma_a: absorption coefficient, 1 / world unit.
        asymmetry: mean cosine of scattering, between -1 and 1: 0 scatters evenly, 0.4 to 0.8 is haze that glows towards the light
            (Henyey and Greenstein).
        up: "x", "y" or "z", for defaults and for a sun in words. Default: see vtkSceneDefaults.
        exposure: what 1 / (W m^-2 sr^-1) shows as white. Default: found from the image.
        tone: "filmic" rolls lamps and bright spots off, "linear" cuts them at white (SetToneCurve of vtkScatteringImageFilter).
        seed: of the random numbers; the same seed gives the same bytes.
        progress: True for a bar, or something to call with a fraction from 0 to 1.

    Returns:
        a Shot: rgb (uint8, height x width x 3), radiance (float32, height x width x wavelengths, W m^-2 sr^-1), image
        (vtkImageData), save(path).

    Raises:
        FileNotFoundError, ValueError, TypeError: for what was given, with the filter's words. KeyboardInterrupt: on Ctrl-C,
        within a fraction of a second.

    Example:
        >>> import shadowcones as sc
        >>> from vtkmodules.vtkFiltersSources import vtkCubeSource
        >>> cube = vtkCubeSource()
        >>> shot = sc.light_shafts(cube, "disc:0,2,0 radius 0.3 facing -y", size=(32, 24), error=0.1)
        >>> shot.rgb.shape, shot.radiance.shape
        ((24, 32, 3), (24, 32, 7))
        >>> shot.save("shafts.png")
    """
    width, height = picture_size(size)
    if not error > 0.0:
        raise ValueError(f"error is {error}: it must be above 0")
    if tone not in ("filmic", "linear"):
        raise ValueError(f'tone must be "filmic" or "linear", not {tone!r}')
    occluders = _meshes.occluders_of(mesh)
    axis = up_axis(up)
    lights = [] if light is None else _lights.lights_of(light, np.eye(3)[axis - 1] if axis else None)
    _run.update(occluders)
    defaults = defaults_of(occluders, lights, axis)
    if not lights:
        lamp = sc.vtkAreaLightSource()
        defaults.PlaceLight(lamp)
        lights = [lamp]
    if camera is None:
        camera = vtkCamera()
        defaults.PlaceCamera(camera, width / height)
    else:
        camera = camera_of(camera)
    if medium is None:
        medium = [0.0] * 6
        defaults.GetMediumBounds(medium)

    image = sc.vtkScatteringImageFilter()
    image.SetInputConnection(occluders.GetOutputPort())
    _lights.connect(image, lights)
    image.SetCamera(camera)
    image.SetResolution(width, height)
    image.SetRelativeErrorGoal(error)
    image.SetMediumBounds(*medium)
    image.SetSigmaS(defaults.GetSigmaS() if sigma_s is None else sigma_s)
    image.SetSigmaA(sigma_a)
    if asymmetry:
        image.SetPhaseFunctionToHenyeyGreenstein()
        image.SetPhaseAsymmetry(asymmetry)
    image.SetSeed(seed)
    image.SetToneCurve(image.Filmic if tone == "filmic" else image.Linear)
    if exposure is not None:
        image.AutoExposureOff()
        image.SetExposure(exposure)
    _run.update(image, progress)
    return Shot(image.GetOutput(), camera, lights)
