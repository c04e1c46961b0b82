#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a medium that is not even does to a shadow's edge: even fog, smooth fog and wisps with the same mean density, by one
scattering and by all of them. The edge is that of a board under a disc of light, seen along itself; the exact width is known.
Drawing needs a display."""

import common
import diagrams
import numpy as np
import scenes
import shadowcones as sc
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

LAMP, RADIUS, BOARD, SIGMA, LEVEL = 5.49, 0.3, 3.2, 0.3, 1.2  # heights, the lamp's radius, scattering, where the edge is measured
BOUNDS = scenes.MEDIUM_BOUNDS
WIDTH = 2.0 * 0.6870 * RADIUS * (BOARD - LEVEL) / (LAMP - BOARD)  # from 10 to 90 % of a disc behind a straight edge
MEDIA = {"even fog": None, "smooth fog": (2, 1.2), "wisps": (16, 2.0)}  # cells of the noise, and how strong it is


def density(points, cells, strength):
    """An image of mean 1 whose logarithm is noise."""
    value = np.exp(strength * scenes.smooth_noise(np.random.default_rng(1), points, cells))
    low, high = np.reshape(BOUNDS, (3, 2)).T
    image = vtkImageData()
    image.SetDimensions(points, points, points)
    image.SetOrigin(*low)
    image.SetSpacing(*((high - low) / (points - 1)))
    image.GetPointData().SetScalars(numpy_to_vtk((value / value.mean()).astype(np.float32).ravel(), deep=True))
    return image


def medium(algorithm, fog):
    """Give an image or a photon map its medium."""
    algorithm.SetSigmaS(SIGMA)
    algorithm.SetMediumBounds(*BOUNDS)
    algorithm.SetDensityData(fog)


def picture(mesh, light, cones, fog, mode, arguments, photons=0):
    """A picture along the board's edge, after an update."""
    image = sc.vtkScatteringImageFilter()
    image.SetInputData(mesh)
    image.SetLightConnection(light.GetOutputPort())
    if cones:
        image.SetConeSetConnection(cones.GetOutputPort())
    camera = common.camera_at((0.0, 2.6, 20.0), (0.0, 2.6, 0.0), up=(0.0, 1.0, 0.0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(2.6)
    image.SetCamera(camera)
    image.SetResolution(arguments.size, arguments.size)
    getattr(image, "SetModeTo" + mode)()
    image.SetMaximumDepth(0)  # even steps: the same places whatever the medium
    image.SetNumberOfSteps(arguments.steps)
    image.SetNumberOfLightSamples(8)
    medium(image, fog)
    if photons:
        maps = sc.vtkPhotonMapFilter()
        maps.SetInputData(mesh)
        maps.SetLightConnection(light.GetOutputPort())
        maps.SetNumberOfPhotons(photons)
        medium(maps, fog)
        image.AddPhotonMapConnection(maps.GetOutputPort(0))
        image.AddPhotonMapConnection(maps.GetOutputPort(1))
    image.Update()
    return image


def light_of(image, name, size):
    """An array of a picture, mean over wavelengths, as rows from the floor up."""
    return common.array(image.GetOutput().GetPointData(), name).reshape(size, size, -1).mean(axis=2).astype(float)


def edge(values, size):
    """Of values across the board's edge at the level of LEVEL: contrast, the distance from 10 to 90 %, the profile."""
    rows = np.abs((np.arange(size) + 0.5) / size * 5.2 - LEVEL) < 0.15
    profile = values[rows].mean(axis=0)
    x = (np.arange(size) + 0.5) / size * 5.2 - 2.6
    dark, lit = profile[(x > -1.3) & (x < -0.7)].mean(), profile[(x > 0.7) & (x < 1.3)].mean()
    share = (profile - dark) / (lit - dark)
    inner = np.abs(x) < 1.0
    places = [np.interp(level, np.maximum.accumulate(share[inner]), x[inner]) for level in (0.1, 0.9)]
    return 1.0 - dark / lit, places[1] - places[0], profile


def measure(name, scene, arguments):
    """One medium: prints its lines of the table; pictures by one scattering and by all, and profiles against no board."""
    board, low_board, light, cones = scene
    fog = density(arguments.points, *MEDIA[name]) if MEDIA[name] else None
    size = arguments.size
    brute = picture(board, light, None, fog, "BruteForce", arguments)
    image = picture(board, light, cones, fog, "Medium", arguments, arguments.photons)
    clear = picture(low_board, light, None, fog, "BruteForce", arguments, arguments.photons)
    leak = np.abs(light_of(image, "InScattering", size) - light_of(brute, "InScattering", size)).max()
    rays = common.array(image.GetOutput().GetFieldData(), "NumberOfOcclusionRays")[0]
    names = ("InScattering", "MultipleScattering")
    shadowed, free = ([light_of(made, each, size) for each in names] for made in (image, clear))
    pictures, profiles = [], []
    for title, once, twice in (("one scattering", 1, 0), ("all of them", 1, 1)):
        seen, whole = (values[0] * once + values[1] * twice for values in (shadowed, free))
        contrast, width, profile = edge(seen / whole, size)
        texture = (np.std(edge(whole, size)[2]) / np.mean(edge(whole, size)[2]))
        print(f"| {name}, {title} | {rays:,.0f} | {leak:.0e} | {contrast:.3f} | {width:.3f} | {texture:.2f} |", flush=True)
        pictures.append(seen)
        profiles.append(profile)
    return pictures, profiles


def curves(profiles, size):
    """What is left of the light across the edge: one scattering, and all of them dashed."""
    drawing = diagrams.Drawing()
    x = np.linspace(-1.3, 1.3, len(profiles[0]))
    at = (np.arange(size) + 0.5) / size * 5.2 - 2.6
    for k, profile in enumerate(profiles):
        drawing.path(np.stack([x, 2.0 * np.interp(x, at, profile)], axis=1), (common.DARK_BLUE, common.VERMILION)[k], 2.5)
    drawing.path([(-1.3, 2.0), (-1.3, 0.0), (1.3, 0.0)], common.INK)
    for side in (-0.5, 0.5):
        drawing.dashes((side * WIDTH, 0.0), (side * WIDTH, 2.1), (0.5, 0.5, 0.5), width=1.0)
    for value in (0, 1):
        drawing.say(str(value), (-1.42, 2.0 * value - 0.08), size=1.4)
    drawing.say("across the edge", (0.0, -0.3), size=1.4)
    return drawing.picture((-1.55, -0.4), (1.45, 2.6), 3 * size)


def shown(values):
    """Values up to 1 as a grey picture, three pixels a value along each side."""
    grey = (255.0 * np.clip(values, 0.0, 1.0) ** (1.0 / 2.2)).round().astype(np.uint8)
    return np.kron(grey, np.ones((3, 3), dtype=np.uint8))[:, :, np.newaxis].repeat(3, axis=2)


def main():
    options = common.parser(__doc__, size=112, vectors=5800)
    options.add_argument("--photons", type=int, default=400000, help="photons of a map (default: 400000)")
    options.add_argument("--steps", type=int, default=96, help="of the march (default: 96)")
    options.add_argument("--points", type=int, default=64, help="points along each axis of a density (default: 64)")
    arguments = common.parse(options)
    light = sc.vtkAreaLightSource()
    light.SetCenter(0.0, LAMP, 0.0)
    light.SetNormal(0.0, -1.0, 0.0)
    light.SetRadius(RADIUS)
    sheet = ((-2.6, BOARD, 1.2), (2.6, 0.0, 0.0), (0.0, 0.0, -2.4), (1, 1))
    board = scenes.label(scenes.sheet(*sheet))
    cones = common.tuned_cones(board, light, arguments.vectors, "Conservative")
    cones.SetMeshConnection(board.GetOutputPort())  # proved
    cones.Update()
    print(f"{common.summary(cones)}; exact width from 10 to 90 %: {WIDTH:.3f}")
    print("| medium | rays | leak | contrast | width | texture |\n|---|---:|---:|---:|---:|---:|")
    scene = board.GetOutput(), scenes.sheet((-2.6, -1.0, 1.2), *sheet[1:]), light, cones  # the other board is below the fog
    made = {name: measure(name, scene, arguments) for name in MEDIA}
    white = 1.25 * np.quantile(np.stack([pictures[1] for pictures, _ in made.values()]), 0.98)
    rows = [[shown(made[name][0][k] / white) for name in MEDIA] for k in (0, 1)]
    rows.append([curves(made[name][1], arguments.size) for name in MEDIA])
    picture_ = common.table(rows, list(MEDIA), ("one scattering", "all of them", "share that is left"))
    entries = ((common.DARK_BLUE, "one scattering"), (common.VERMILION, "all of them"), ((0.5, 0.5, 0.5), "exact width of the edge"))
    common.save(common.stack(picture_, common.key(entries, picture_.shape[1])), f"{arguments.output}/fog-edges.png")


if __name__ == "__main__":
    main()
