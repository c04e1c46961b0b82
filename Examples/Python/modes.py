#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Chair and tree by all six modes, each over its signed error: blue is too dark, red is too bright."""

import os

import common
import numpy as np
import scenes

MODES = ("Guided", "Volume", "Soft", "BruteForce", "Medium", "Fast")
# Cones that hold the shadow, cones as dark as the shadow, and discs that stand for the mesh. BruteForce takes none.
TUNING = {"Guided": "Conservative", "Volume": "Conservative", "Medium": "Conservative", "Fast": "Preview", "Soft": "Soft"}
# How many times --vectors each of them wants.
VECTORS = {"Conservative": 1, "Preview": 1, "Soft": 8}
TOO_DARK = np.array((33.0, 72.0, 180.0))
TOO_BRIGHT = np.array((190.0, 20.0, 30.0))


def medium_term(image):
    """In-scattered radiance of each pixel, the mean over wavelengths."""
    width, height, _ = image.GetOutput().GetDimensions()
    return common.array(image.GetOutput().GetPointData(), "InScattering").mean(axis=1).reshape(height, width)


def converged(room, light, size, goal):
    """The truth: Guided along the whole of every ray, which trusts no cones. Its samples differ from those of the images."""
    image = common.light_shafts(room, light, None, "Guided", size)
    image.SetRelativeErrorGoal(goal)
    image.SetMaximumSamples(16384)
    image.SetSeed(7)
    image.Update()
    return medium_term(image)


def error_map(error, scale):
    """White where there is no error, full colour where it is `scale` and more."""
    share = np.clip(error / scale, -1.0, 1.0)[:, :, np.newaxis]
    ends = np.where(share < 0.0, TOO_DARK, TOO_BRIGHT)
    return (255.0 + np.abs(share) * (ends - 255.0)).round().astype(np.uint8)


def figure(image, name):
    return image.GetOutput().GetFieldData().GetArray(name).GetTuple1(0)


def main():
    options = common.parser(__doc__, size=256, vectors=5800)
    options.add_argument("--scale", type=float, default=0.1,
                         help="error of full colour, as a share of the mean of the truth (default: 0.1)")
    options.add_argument("--goal", type=float, default=0.005, help="relative error of the truth (default: 0.005)")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    for model in ("chair", "tree"):
        occluders = scenes.label(scenes.read(os.path.join(arguments.data, model + ".vtp")))
        room = scenes.put_in_room(occluders, arguments.data)
        cones = {tuning: common.tuned_cones(room, light, factor * arguments.vectors, tuning)
                 for tuning, factor in VECTORS.items()}
        for tuning, cone_set in cones.items():
            print(f"{model}, {tuning}: {common.summary(cone_set)}", flush=True)
        volume = common.visibility_volume(room, light, cones["Conservative"])
        volume.Update()
        truth = converged(room, light, arguments.size, arguments.goal)

        pictures, errors, exposure = [], [], None
        for mode in MODES:
            image = common.light_shafts(room, light, cones.get(TUNING.get(mode)), mode, arguments.size)
            if mode == "Volume":
                image.SetVisibilityVolumeConnection(volume.GetOutputPort())
            if exposure:  # that of the first, so that the others may be darker or brighter
                image.AutoExposureOff()
                image.SetExposure(exposure)
            image.Update()
            exposure = figure(image, "Exposure")
            error = (medium_term(image) - truth) / truth.mean()
            print(f"{model}, {mode}: {figure(image, 'RenderSeconds'):.2f} s, "
                  f"{figure(image, 'NumberOfOcclusionRays'):,.0f} occlusion rays, "
                  f"error {np.sqrt((error**2).mean()):.2%}, bias {error.mean():+.2%}", flush=True)
            pictures.append(common.pixels(image.GetOutput()))
            errors.append(error_map(error, arguments.scale))
        common.save(common.table([pictures, errors], MODES, ["image", f"error, ±{arguments.scale:.0%}"]),
                    os.path.join(arguments.output, f"modes-{model}.png"), levels=64)


if __name__ == "__main__":
    main()
