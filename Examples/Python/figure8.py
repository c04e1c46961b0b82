#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Chair and tree in fog, by every mode (the paper's figure 8): brute force, medium, fast. One exposure for all."""

import os

import common
import scenes

MODELS = ("chair", "tree")
MODES = ("BruteForce", "Medium", "Fast")


def main():
    options = common.parser(__doc__, size=400, vectors=5800)
    options.add_argument("--samples", type=int, default=16, help="light points at a march sample (default: 16)")
    options.add_argument("--models", nargs="+", choices=MODELS, default=MODELS, help="models to show (default: both)")
    options.add_argument("--modes", nargs="+", choices=MODES, default=MODES, help="modes to show (default: all)")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    rows = []
    exposure = None
    for model in arguments.models:
        occluders = scenes.label(scenes.read(os.path.join(arguments.data, model + ".vtp")))
        room = scenes.put_in_room(occluders, arguments.data)
        cones = common.cone_set(common.shadow_vectors(room, light, arguments.vectors))
        print(f"{model}: {common.summary(cones)}", flush=True)
        rows.append([])
        for mode in arguments.modes:
            image = common.light_shafts(room, light, cones, mode, arguments.size)
            image.SetToneCurveToFilmic()
            image.SetNumberOfLightSamples(arguments.samples)
            image.SetNumberOfSurfaceLightSamples(64)
            if exposure:
                image.AutoExposureOff()
                image.SetExposure(exposure)
            image.Update()
            field = image.GetOutput().GetFieldData()
            exposure = field.GetArray("Exposure").GetTuple1(0)
            print(f"{model}, {mode}: {field.GetArray('RenderSeconds').GetTuple1(0):.2f} s, "
                  f"{field.GetArray('NumberOfOcclusionRays').GetTuple1(0):,.0f} occlusion rays", flush=True)
            rows[-1].append(common.pixels(image.GetOutput()))
            common.save(rows[-1][-1], os.path.join(arguments.output, f"{model}-{mode.lower()}.png"))
    common.save(common.table(rows, arguments.modes, arguments.models), os.path.join(arguments.output, "figure8.png"))


if __name__ == "__main__":
    main()
