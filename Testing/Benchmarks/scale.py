#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Large runs, each in a process of its own: processor seconds, the peak of memory above what was there before, and its formula.

    python3 Testing/Benchmarks/scale.py                      # all rows, some minutes each
    python3 Testing/Benchmarks/scale.py --rows volume image  # some
    python3 Testing/Benchmarks/scale.py --part 100           # a hundredth of the items: for a look at the program

Formulas are those of Documentation/7-performance.md. "lost" counts what was asked of the results and did not hold: sizes, finite values,
the same bytes in tiles as in one piece, a message where memory ends. A process may take --limit gigabytes of addresses, no more.
"""

import argparse
import ctypes
import hashlib
import json
import os
import resource
import subprocess
import sys
import time

ROWS = {}
BOUNDS = (-2.75, 2.75, 0.0, 5.2, -2.75, 2.75)


def row(run):
    """A function that makes what a row needs and yields its measurements."""
    ROWS[run.__name__] = run
    return run


def status(name):
    """A figure of the system about this process, in bytes."""
    with open("/proc/self/status", encoding="ascii") as lines:
        return next(1024 * int(line.split()[1]) for line in lines if line.startswith(name + ":"))


class Measured:
    """With it: processor seconds, and the peak of memory over what was there before."""

    def __enter__(self):
        ctypes.CDLL(None).malloc_trim(0)  # what was freed before would hide what is taken next
        with open("/proc/self/clear_refs", "w", encoding="ascii") as peak:
            peak.write("5")
        self.before = status("VmHWM")
        self.start = time.process_time()
        return self

    def __exit__(self, *_):
        self.seconds = time.process_time() - self.start
        self.peak = status("VmHWM") - self.before


def line(what, measured, formula, checks):
    """A line of the table; checks are what has to be true."""
    return {"what": what, "seconds": measured.seconds, "peak": measured.peak, "formula": formula,
            "lost": [name for name, holds in checks.items() if not holds]}


def arrays_of(data):
    """The point arrays of an image as numpy arrays by name; but for its time."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    points = data.GetPointData()
    names = [points.GetArrayName(k) for k in range(points.GetNumberOfArrays())]
    return {name: vtk_to_numpy(points.GetArray(name)) for name in names if name != "RenderSeconds"}


def finite(data):
    """No NaN and no infinity in the point arrays."""
    import numpy as np

    return all(np.isfinite(part).all() for values in arrays_of(data).values()
               for part in np.array_split(values, 1 + values.size // 10000000))


def grid_of_triangles(count, gap):
    """About so many triangles in a plane of 4 x 4 units, upright waves in it; with a gap each stands alone."""
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

    side = max(int(round((count / (1 if gap else 2)) ** 0.5)), 2)
    x, z = np.meshgrid(np.arange(side + (0 if gap else 1)), np.arange(side + (0 if gap else 1)), indexing="ij")
    if gap:
        corners = np.array([(0.0, 0.0), (0.8, 0.0), (0.4, 0.8)])
        flat = (np.stack((x, z), -1).reshape(-1, 1, 2) + corners).reshape(-1, 2)
        cells = np.arange(3 * side * side).reshape(-1, 3)
    else:
        flat = np.stack((x, z), -1).reshape(-1, 2)
        first = (np.arange(side)[:, None] * (side + 1) + np.arange(side)).reshape(-1)
        cells = np.stack((first, first + 1, first + side + 1, first + 1, first + side + 2, first + side + 1), -1).reshape(-1, 3)
    places = np.empty((len(flat), 3))
    places[:, 0], places[:, 2] = (4.0 * flat / side - 2.0).T
    places[:, 1] = 3.0 + 0.1 * np.sin(3.0 * places[:, 0]) * np.sin(3.0 * places[:, 2])
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(places, deep=True))
    polygons = vtkCellArray()
    polygons.SetData(numpy_to_vtkIdTypeArray(np.arange(0, 3 * len(cells) + 1, 3), deep=True),
                     numpy_to_vtkIdTypeArray(cells.reshape(-1), deep=True))
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(polygons)
    return mesh


def lamp():
    import scenes

    light = scenes.ceiling_light()
    light.Update()
    return light.GetOutput()


def image_of(mesh, size):
    """An image filter that looks at the room from the front, without anything after it."""
    import scenes
    import shadowcones as sc

    image = sc.vtkScatteringImageFilter()
    image.SetInputData(mesh)
    image.SetLightData(lamp())
    image.SetCamera(scenes.front_camera())
    image.SetMediumBounds(*BOUNDS)
    image.SetResolution(size, size)
    image.AutoExposureOff()
    image.SetExposure(1.0)
    image.SetModeToGuided()
    image.SetRelativeErrorGoal(0.5)
    return image


def volume_image(size):
    """The same in mode Volume, and what fills its grid; all is there but the image."""
    import scenes
    import shadowcones as sc

    mesh = grid_of_triangles(2000, gap=True)
    volume = sc.vtkVisibilityVolume()
    volume.SetMeshData(mesh)
    volume.SetLightData(lamp())
    volume.SetBounds(*BOUNDS)
    image = image_of(mesh, 8)
    image.SetVisibilityVolumeConnection(volume.GetOutputPort())
    image.SetModeToVolume()
    image.Update()
    image.SetResolution(size, size)
    return image


def labelled(mesh):
    import shadowcones as sc

    occluders = sc.vtkLabelOccluders()
    occluders.SetInputData(mesh)
    occluders.Update()
    return occluders.GetOutput()


def mesh_bytes(mesh, tree):
    """Of a mesh as it is kept, with so many bytes a triangle for what is made of it."""
    return 24.0 * mesh.GetNumberOfPoints() + (32.0 + tree) * mesh.GetNumberOfCells()


def vectors_of(mesh, photons):
    import scenes
    import shadowcones as sc

    vectors = sc.vtkShadowVectorFilter()
    vectors.SetInputData(mesh)
    vectors.SetLightData(lamp())
    vectors.SetNumberOfPhotons(photons)
    vectors.SetMinimumVectorsPerOccluder(0)
    return vectors


def photon_bytes(vectors):
    """Of vectors, paths and shadow photons, while they are traced."""
    return sum(bytes_each * vectors.GetOutput(port).GetNumberOfPoints() for port, bytes_each in enumerate((120, 250, 0)))


@row
def photons(part):
    """Shadow vectors of ten million photons."""
    import scenes

    count = 10000000 // part
    vectors = vectors_of(labelled(scenes.read(os.path.join(scenes.DATA, "chair.vtp"))), count)
    with Measured() as measured:
        vectors.Update()
    found = [vectors.GetOutput(port).GetNumberOfPoints() for port in range(3)]
    yield line(f"{count:,} photons: {found[0]:,} vectors, {found[1]:,} paths", measured, photon_bytes(vectors),
               {"a path for nearly every photon": 0.4 * count < found[1] <= count, "vectors": found[0] > 0,
                "finite vectors": finite(vectors.GetOutput(0)), "finite paths": finite(vectors.GetOutput(1))})


@row
def triangles(part):
    """Labels, vectors and a small image of ten million triangles."""
    count = 10000000 // part
    mesh = grid_of_triangles(count, gap=False)
    number = mesh.GetNumberOfCells()
    with Measured() as measured:
        occluders = labelled(mesh)
    labels = occluders.GetCellData().GetArray("OccluderId")
    yield line(f"{number:,} triangles, labelled", measured, LABEL_BYTES * number,
               {"one piece": labels is not None and labels.GetRange() == (0.0, 0.0)})
    vectors = vectors_of(occluders, 10000)
    with Measured() as measured:
        vectors.Update()
    yield line(f"{number:,} triangles, vectors", measured, mesh_bytes(mesh, ID_BYTES + KEPT_TREE_BYTES + CLOSED_BYTES),
               {"vectors": vectors.GetOutput(0).GetNumberOfPoints() > 0, "finite": finite(vectors.GetOutput(0))})
    vectors.ReleasePreparedScene()
    image = image_of(mesh, 16)
    with Measured() as measured:
        image.Update()
    yield line(f"{number:,} triangles, image of 16 x 16, Guided", measured, mesh_bytes(mesh, BUILT_TREE_BYTES),
               {"finite": finite(image.GetOutput())})
    kept = float(image.GetPreparedMemory())
    measured.peak = kept
    yield line(f"{number:,} triangles, kept by the image", measured, mesh_bytes(mesh, KEPT_TREE_BYTES), {"kept": kept > 0.0})


@row
def cones(part):
    """A hundred thousand occluders with a cone each: fitted, then asked by an image and a probe."""
    import scenes
    import shadowcones as sc
    from vtkmodules.vtkCommonDataModel import vtkImageData

    count = 100000 // part
    mesh = labelled(grid_of_triangles(count, gap=True))
    vectors = vectors_of(mesh, 60 * count)
    vectors.Update()
    fit = sc.vtkConeSetFilter()
    fit.SetTuningToManual()
    fit.CertifyOff()
    fit.SetInputData(vectors.GetOutput(0))
    with Measured() as measured:
        fit.Update()
    found = fit.GetOutput().GetNumberOfPoints()
    of_vectors = vectors.GetOutput(0).GetNumberOfPoints()
    yield line(f"{found:,} cones of {of_vectors:,} vectors, fitted", measured, 150.0 * of_vectors + FITTED_CONE_BYTES * found,
               {"about a cone each": 0.95 * count < found, "finite": finite(fit.GetOutput())})
    image = image_of(mesh, 64)
    image.SetConeSetData(fit.GetOutput())
    with Measured() as measured:
        image.Update()
    of_mesh = mesh_bytes(mesh, ID_BYTES + BUILT_TREE_BYTES + OCCLUDER_BYTES)  # an occluder each
    yield line(f"{found:,} cones, image of 64 x 64, Guided", measured, of_mesh + CONE_BYTES * found,
               {"finite": finite(image.GetOutput())})
    image.ReleasePreparedScene()
    points = vtkImageData()
    points.SetDimensions(100, 100, 100 if part == 1 else 10)
    points.SetOrigin(-2.0, 0.5, -2.0)
    points.SetSpacing(0.04, 0.02, 0.04)
    probe = sc.vtkConeSetProbe()
    probe.SetInputData(points)
    probe.SetConeSetData(fit.GetOutput())
    probe.SetLightData(lamp())
    probe.SetMeshData(mesh)
    probe.SetMethodToExact()
    probe.SetNumberOfLightSamples(4)
    with Measured() as measured:
        probe.Update()
    asked = points.GetNumberOfPoints()
    yield line(f"{found:,} cones, {asked:,} points probed", measured,
               66.0 * asked + of_mesh + PROBED_CONE_BYTES * found, {"finite": finite(probe.GetOutput())})


@row
def volume(part):
    """A grid of 512 points a side."""
    import scenes
    import shadowcones as sc

    side = max(int(512 / part ** (1.0 / 3.0)), 16)
    one = sc.vtkVisibilityVolume()
    one.SetMeshData(grid_of_triangles(2000, gap=True))
    one.SetLightData(lamp())
    one.SetBounds(*BOUNDS)
    one.SetDimensions(side, side, side)
    one.SetNumberOfLightSamples(1)
    one.SetBrickParts(1)
    with Measured() as measured:
        one.Update()
    yield line(f"volume of {side}^3 points", measured, VOLUME_BYTES * side ** 3,
               {"all points": one.GetOutput().GetNumberOfPoints() == side ** 3, "finite": finite(one.GetOutput())})


@row
def image(part):
    """An image of 4096 x 4096 pixels, in one piece."""
    side = max(int(4096 / part ** 0.5), 64)
    one = volume_image(side)
    with Measured() as measured:
        one.Update()
    yield line(f"image of {side} x {side}, Volume", measured, PIXEL_BYTES * side * side,
               {"all pixels": one.GetOutput().GetNumberOfPoints() == side ** 2, "finite": finite(one.GetOutput())})


def tiles_of(side, tile):
    for low in range(0, side, tile):
        for left in range(0, side, tile):
            yield (left, min(left + tile, side) - 1, low, min(low + tile, side) - 1, 0, 0)


def same_in_tiles(whole_one, one, side, tile):
    """Are all arrays of all tiles those of the whole?"""
    import numpy as np

    whole_one.UpdateWholeExtent()
    whole = {name: values.reshape(side, side, -1) for name, values in arrays_of(whole_one.GetOutput()).items()}
    same = True
    for extent in tiles_of(side, tile):
        one.UpdateExtent(extent)
        across = extent[1] - extent[0] + 1
        for name, values in arrays_of(one.GetOutput()).items():
            part = whole[name][extent[2]:extent[3] + 1, extent[0]:extent[1] + 1]
            same = same and np.array_equal(part, values.reshape(-1, across, values.size // (across * (extent[3] - extent[2] + 1))))
    return same


@row
def tiles(part):
    """An image of 8192 x 8192, which would take 12 GB, through VTK's streamer: tiles come one after the other."""
    from vtkmodules.vtkImagingCore import vtkImageDataStreamer

    small = volume_image(96)
    mesh = grid_of_triangles(2000, gap=True)
    same = {"the same bytes in tiles, Volume": same_in_tiles(small, volume_image(96), 96, 40),
            "the same bytes in tiles, Guided": same_in_tiles(image_of(mesh, 96), image_of(mesh, 96), 96, 40)}

    def streamed(one, pieces):
        streamer = vtkImageDataStreamer()
        streamer.SetInputConnection(one.GetOutputPort())
        streamer.SetNumberOfStreamDivisions(pieces)
        streamer.UpdateWholeExtent()
        return streamer.GetOutput()

    def hash_of(data):
        from vtkmodules.util.numpy_support import vtk_to_numpy

        return hashlib.sha256(vtk_to_numpy(data.GetPointData().GetScalars()).tobytes()).hexdigest()

    same["the streamed picture is the picture"] = hash_of(small.GetOutput()) == hash_of(streamed(volume_image(96), 7))
    side = max(int(8192 / part ** 0.5), 128)
    one = volume_image(side)
    pieces = 16
    with Measured() as measured:
        picture = streamed(one, pieces)
    yield line(f"image of {side} x {side}, Volume, in {pieces} pieces", measured, PIXEL_BYTES * side * side / pieces + 3.0 * side * side,
               {**same, "all pixels": picture.GetNumberOfPoints() == side ** 2})


@row
def short(part):
    """Too little memory for an image in one piece: a message, and enough for tiles."""
    from vtkmodules.vtkCommonCore import VTK_STRING

    side = 1024  # of fewer pixels there is always memory for all: threads have room of their own
    del part
    one = volume_image(side)
    in_tiles = volume_image(side)  # one that was asked for the whole goes on asking for it
    said = []

    def note(_, __, text):
        said.append(text)

    note.CallDataType = VTK_STRING
    one.AddObserver("ErrorEvent", note)
    in_tiles.AddObserver("ErrorEvent", note)
    formula = PIXEL_BYTES * side * side
    ctypes.CDLL(None).malloc_trim(0)
    limit = status("VmSize") + int(0.5 * formula)
    resource.setrlimit(resource.RLIMIT_AS, (limit, resource.getrlimit(resource.RLIMIT_AS)[1]))
    one.UpdateWholeExtent()
    checks = {"a message where memory ends": any("Rendering failed: there is not enough memory" in text for text in said), "no pixels then": one.GetOutput().GetNumberOfPoints() == 0}
    said.clear()
    tile = side // 4
    pixels = 0
    with Measured() as measured:
        for extent in tiles_of(side, tile):
            in_tiles.UpdateExtent(extent)
            pixels += in_tiles.GetOutput().GetNumberOfPoints()
            checks["finite"] = checks.get("finite", True) and finite(in_tiles.GetOutput())
    checks["all tiles"] = pixels == side * side and not said
    yield line(f"image of {side} x {side} where there is memory for half of it, in tiles of {tile}", measured,
               PIXEL_BYTES * tile * tile, checks)


# Bytes, as the page on performance states them.
LABEL_BYTES = 310.0
ID_BYTES = 4.0
OCCLUDER_BYTES = 125.0
KEPT_TREE_BYTES = 120.0
BUILT_TREE_BYTES = 160.0
CLOSED_BYTES = 80.0
FITTED_CONE_BYTES = 2500.0
CONE_BYTES = 1700.0
PROBED_CONE_BYTES = 700.0
VOLUME_BYTES = 15.0
PIXEL_BYTES = 16.0 * 7.0 + 68.0


def worker(options):
    """One row, in this process."""
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
    import scenes  # noqa: F401  what it loads is there before

    most = int(options.limit * 1e9)
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    for measured in ROWS[options.worker](options.part):
        print("LINE " + json.dumps(measured), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", nargs="+", choices=list(ROWS), default=list(ROWS), help="some of them (default: all)")
    parser.add_argument("--part", type=int, default=1, help="one of so many parts of the items (default: 1)")
    parser.add_argument("--limit", type=float, default=14.0, help="gigabytes of addresses a process may have (default: 14)")
    parser.add_argument("--worker", choices=list(ROWS), help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.worker:
        worker(options)
        return
    print("| run | processor s | peak, MB | formula, MB | peak / formula | lost |\n|---|---|---|---|---|---|", flush=True)
    lost = 0
    for name in options.rows:
        command = [sys.executable, os.path.abspath(__file__), "--worker", name, "--part", str(options.part), "--limit", str(options.limit)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        for text in done.stdout.splitlines():
            if text.startswith("LINE "):
                one = json.loads(text[len("LINE "):])
                lost += len(one["lost"])
                ratio = f"{one['peak'] / one['formula']:.2f}" if one["formula"] else ""
                print(f"| {one['what']} | {one['seconds']:.1f} | {1e-6 * one['peak']:.0f} | {1e-6 * one['formula']:.0f} | {ratio} | "
                      f"{len(one['lost'])}{': ' if one['lost'] else ''}{', '.join(one['lost'])} |", flush=True)
        if done.returncode:
            lost += 1
            print(f"| {name} | | | | | it ended with {done.returncode}: {done.stderr.strip()[-300:]} |", flush=True)
    print(f"lost: {lost}")
    sys.exit(1 if lost else 0)


if __name__ == "__main__":
    main()
