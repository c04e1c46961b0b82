#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""One rendering of the chair, shown darker, as it exposes itself, and brighter: no ray is traced again."""

import os

import common
import scenes
import shadowcones as sc

STOPS = (-1, 0, 1)


def main():
    arguments = common.parse(common.parser(__doc__, size=400, vectors=5800))
    light = scenes.ceiling_light()
    occluders = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))
    room = scenes.put_in_room(occluders, arguments.data)
    cones = common.cone_set(common.shadow_vectors(room, light, arguments.vectors))
    image = common.light_shafts(room, light, cones, "Guided", arguments.size)

    picture = sc.vtkToneMapRadiance()
    picture.SetInputConnection(image.GetOutputPort())
    picture.SetToneCurveToFilmic()
    picture.Update()
    found = picture.GetOutput().GetFieldData().GetArray("Exposure").GetTuple1(0)
    print(f"exposure {found:.4g}")

    picture.AutoExposureOff()
    pictures = []
    for stop in STOPS:
        picture.SetExposure(found * 2.0**stop)
        picture.Update()
        pictures.append(common.pixels(picture.GetOutput()))
    titles = ["half", "as found", "twice"]
    common.save(common.table([pictures], titles), os.path.join(arguments.output, "exposures.png"))


if __name__ == "__main__":
    main()
