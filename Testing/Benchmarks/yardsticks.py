#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Other renderers on the room of the benchmarks: seconds of the fog's picture at equal error, and how far pictures agree. With --bounces
surfaces are grey, light bounces, and the pictures of photon maps and of Cycles are compared: fog and surfaces together.

Runs Cycles (package blender) and POV-Ray (package povray) where they are installed, and says which are not.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np
import yardstick_povray
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkMath
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
import scenes  # noqa: E402
import shadowcones as sc  # noqa: E402

SIGMA = 0.12
LAMP = (0.0, 5.49, 0.0)
RADIUS = 0.5
GOALS = (0.2, 0.1, 0.05, 0.02, 0.01, 0.005)
CYCLES_SAMPLES = (4, 16, 64, 256, 1024)
POVRAY_KNOBS = ((8, 4), (16, 4), (16, 8), (32, 8), (64, 16), (128, 16))  # media samples, lights along a side
ERRORS = (0.05, 0.02, 0.01, 0.005)


def room_of(name):
    """Occluders with the walls, without reflectances: every surface is black."""
    occluders = scenes.label(scenes.read(os.path.join(scenes.DATA, name + ".vtp")))
    room = scenes.put_in_room(occluders)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(room.GetOutputPort())
    triangles.Update()
    mesh = triangles.GetOutput()
    mesh.GetCellData().RemoveArray("Reflectance")
    return mesh


def described(mesh, size, threads):
    """All that another renderer has to know."""
    camera = scenes.front_camera()
    back = np.array(camera.GetPosition()) - camera.GetFocalPoint()
    back /= np.linalg.norm(back)
    right = np.cross(camera.GetViewUp(), back)
    right /= np.linalg.norm(right)
    bounds = np.array(scenes.MEDIUM_BOUNDS).reshape(3, 2).T
    return {
        "points": vtk_to_numpy(mesh.GetPoints().GetData()).astype(float),
        "triangles": vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3),
        "bounds": bounds, "sigma": SIGMA, "lamp": np.array(LAMP), "radius": RADIUS,
        "position": np.array(camera.GetPosition()), "right": right, "up": np.cross(back, right), "back": back,
        "angle": vtkMath.RadiansFromDegrees(camera.GetViewAngle()), "size": size, "threads": threads,
        "reflectance": 0.0, "bounces": 0, "seed": 0,
    }


def own_filter(mesh, size):
    light = scenes.ceiling_light()
    light.SetNumberOfWavelengths(3)
    image = sc.vtkScatteringImageFilter()
    image.SetInputData(mesh)
    image.SetLightConnection(light.GetOutputPort())
    image.SetCamera(scenes.front_camera())
    image.SetMediumBounds(*scenes.MEDIUM_BOUNDS)
    image.SetSigmaS(SIGMA)
    image.SetResolution(size, size)
    image.SetModeToGuided()
    image.SetNumberOfEdgeSamples(1)
    image.SetNumberOfSurfaceLightSamples(0)
    image.LightVisibleOff()
    return image


def own_picture(image, goal, seed, most=1024):
    """As a first image: the search tree is built anew."""
    image.ReleasePreparedScene()
    image.SetRelativeErrorGoal(goal)
    image.SetMaximumSamples(most)
    image.SetSeed(seed)
    processor, clock = time.process_time(), time.perf_counter()
    image.Update()
    seconds = [time.process_time() - processor, time.perf_counter() - clock]
    size = image.GetResolution()[0]
    return vtk_to_numpy(image.GetOutput().GetPointData().GetArray("InScattering"))[:, 0].reshape(size, size), seconds


def bounced_picture(mesh, arguments, seed):
    """Radiance, and what medium and surfaces have of it."""
    image = own_filter(mesh, arguments.size)
    photons = sc.vtkPhotonMapFilter()
    photons.SetInputData(mesh)
    photons.SetLightConnection(image.GetInputConnection(1, 0))
    photons.SetMediumBounds(*scenes.MEDIUM_BOUNDS)
    photons.SetSigmaS(SIGMA)
    photons.SetReflectance(arguments.reflectance)
    photons.SetNumberOfPhotons(arguments.photons)
    photons.SetMaximumBounces(arguments.bounces)
    photons.SetSeed(seed)
    image.SetPhotonMapConnection(photons.GetOutputPort(0))
    image.AddPhotonMapConnection(photons.GetOutputPort(1))
    image.SetReflectance(arguments.reflectance)
    image.SetNumberOfSurfaceLightSamples(64)
    image.SetRelativeErrorGoal(0.005)
    image.SetSeed(seed)
    processor = time.process_time()
    image.Update()
    seconds = time.process_time() - processor
    values = image.GetOutput().GetPointData()
    pictures = {name: vtk_to_numpy(values.GetArray(name))[:, 0].reshape(arguments.size, -1).astype(float)
                for name in ("Radiance", "InScattering", "SurfaceRadiance", "MultipleScattering", "IndirectSurface")}
    return pictures, seconds


def compare_bounces(mesh, room, arguments):
    """Two pictures of each renderer: half their difference is the noise of their mean."""
    ours, seconds = zip(*(bounced_picture(mesh, arguments, seed) for seed in (1, 2)))
    room.update(reflectance=arguments.reflectance, bounces=arguments.bounces)
    theirs, cycles_seconds = [], 0.0
    with tempfile.TemporaryDirectory() as folder:
        for seed in (1, 2):
            room["seed"] = seed
            (_, picture, spent), = cycles_pictures(room, folder, (arguments.samples,))
            theirs.append(picture.astype(float))
            cycles_seconds += spent[0]
    for name in ours[0]:
        print(f"{name:<20} mean {np.mean([pictures[name].mean() for pictures in ours]):.5f}")
    own, other = ([coarse(p) for p in pair] for pair in ([pictures["Radiance"] for pictures in ours], theirs))
    noises = [np.sqrt(np.mean((a - b) ** 2)) / 2.0 / ((a + b) / 2.0).mean() for a, b in (own, other)]
    mean_noises = [abs(a.mean() - b.mean()) / (a.mean() + b.mean()) for a, b in (own, other)]
    a, b = sum(own) / 2.0, sum(other) / 2.0
    print(f"ours over Cycles: mean {a.mean() / b.mean() - 1.0:+.2%} (noise {mean_noises[0]:.2%} and {mean_noises[1]:.2%})")
    print(f"8 x 8 pixels: root mean square {error_of(a, b):.2%} (noise {noises[0]:.2%} and {noises[1]:.2%})")
    print(f"seconds of the processor: ours {sum(seconds):.1f}, Cycles {cycles_seconds:.1f}")
    print("ours over Cycles in percent, from the upper row of blocks on:")
    for row in (100.0 * (a / b - 1.0))[::-1]:
        print("".join(f"{value:+7.1f}" for value in row))


def cycles_pictures(room, folder, samples=CYCLES_SAMPLES):
    room_file, out_file = os.path.join(folder, "room.npz"), os.path.join(folder, "cycles.npz")
    np.savez(room_file, **room)
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "yardstick_cycles.py")
    done = subprocess.run(["blender", "-b", "--factory-startup", "-P", script, "--", room_file, out_file,
                           *map(str, samples)], capture_output=True, text=True, check=False)
    if not os.path.exists(out_file):
        raise SystemExit("blender gave no pictures:\n" + done.stdout[-2000:] + done.stderr[-2000:])
    found = np.load(out_file)
    return [(f"{count} samples", image, seconds)
            for count, image, seconds in zip(samples, found["images"], found["seconds"])]


def error_of(picture, truth):
    return np.sqrt(np.mean((picture - truth) ** 2)) / truth.mean()


def seconds_at(error, curve):
    """On the curve (error, seconds), by logarithms, and never beyond its ends: as text."""
    curve = sorted(curve, reverse=True)
    if error >= curve[0][0]:
        return curve[0][1], "<= "
    if error < curve[-1][0]:
        return None, "never"
    for (e0, t0), (e1, t1) in zip(curve, curve[1:]):
        if e1 <= error <= e0:
            share = np.log(e0 / error) / np.log(e0 / e1)
            return float(np.exp(np.log(t0) + share * np.log(t1 / t0))), ""
    return None, "never"


def coarse(picture):
    """Means over 8 x 8 pixels: what noise is left in them is small."""
    side = picture.shape[0] // 8
    return picture[:8 * side, :8 * side].reshape(side, 8, side, 8).mean(axis=(1, 3))


def print_curves(curves, truth):
    print("renderer, setting: error, seconds of the processor, seconds by the clock")
    for name, runs in curves.items():
        for setting, picture, seconds in runs:
            print(f"  {name:<22} {setting:<22} {error_of(picture, truth):8.2%} {seconds[0]:9.2f} {seconds[1]:9.2f}")
    print("\nseconds of the processor at an error; in brackets times what our own first image takes")
    points = {name: [(error_of(p, truth), s[0]) for _, p, s in runs] for name, runs in curves.items()}
    own = next(iter(points))
    print(f"  {'':<22}" + "".join(f"{error:>20.1%}" for error in ERRORS))
    for name, curve in points.items():
        cells = []
        for error in ERRORS:
            seconds, mark = seconds_at(error, curve)
            base, _ = seconds_at(error, points[own])
            ratio = f" ({seconds / base:.0f} x)" if seconds and base and name != own else ""
            cells.append(f"{mark}{seconds:.2f}{ratio}" if seconds else mark)
        print(f"  {name:<22}" + "".join(f"{cell:>20}" for cell in cells))
    print("\nagreement of the best picture with ours: of its mean, and of means over 8 x 8 pixels, root mean square over the mean")
    for name, runs in list(curves.items())[1:]:
        best = runs[-1][1]
        print(f"  {name:<22} mean {best.mean() / truth.mean() - 1.0:+.2%}, 8 x 8 pixels "
              f"{error_of(coarse(best), coarse(truth)):.2%}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scene", default="chair", help="a mesh of Data/: chair, tree or blob")
    parser.add_argument("--size", type=int, default=128, help="pixels along a side")
    parser.add_argument("--threads", type=int, default=2, help="of the other renderers")
    parser.add_argument("--bounces", type=int, help="grey surfaces, and as many bounces after the first, in Cycles and ours alone")
    parser.add_argument("--reflectance", type=float, default=0.6, help="with --bounces: of the surfaces")
    parser.add_argument("--photons", type=int, default=1000000, help="with --bounces: photons of a picture of ours")
    parser.add_argument("--samples", type=int, default=256, help="with --bounces: samples of a pixel of Cycles")
    arguments = parser.parse_args()
    mesh = room_of(arguments.scene)
    room = described(mesh, arguments.size, arguments.threads)
    if arguments.bounces is not None:
        if not shutil.which("blender"):
            raise SystemExit("There is no program blender (Debian: package blender).")
        compare_bounces(mesh, room, arguments)
        return
    image = own_filter(mesh, arguments.size)
    truth = np.mean([own_picture(image, 0.001, seed, 1 << 16)[0] for seed in (101, 102)], axis=0)
    curves = {"ours, first image": [(f"goal {goal}", *own_picture(image, goal, 1)) for goal in GOALS]}
    with tempfile.TemporaryDirectory() as folder:
        if shutil.which("blender"):
            curves["Cycles"] = cycles_pictures(room, folder)
        else:
            print("Cycles is left out: there is no program blender (Debian: package blender).")
        if shutil.which("povray"):
            curves["POV-Ray"] = [(f"{knobs[0]} places, {knobs[1]}^2 lights", *yardstick_povray.render(room, knobs, folder))
                                 for knobs in POVRAY_KNOBS]
        else:
            print("POV-Ray is left out: there is no program povray (Debian: package povray).")
    print_curves(curves, truth)


if __name__ == "__main__":
    main()
