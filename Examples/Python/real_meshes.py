#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The whole chain on meshes that nobody made for it: cones and light shafts of the bunny, the horse and the cat."""

import os

import common
import scenes
from vtkmodules.vtkRenderingCore import vtkCamera


def default_meshes(data):
    paths = [os.path.join(common.REAL_MESHES, name) for name in ("bunny.obj", "horse.3ds", "cat.3ds")]
    found = [path for path in paths if os.path.exists(path)]
    if found:
        return found
    print("The package glmark2-data is not installed: the blob stands in for its meshes")
    return [os.path.join(data, "blob.vtp")]


def side_camera():
    camera = vtkCamera()
    camera.SetPosition(5.0, 3.4, 9.5)
    camera.SetFocalPoint(0.0, 1.25, 0.0)
    camera.SetViewAngle(26.0)
    return camera


def main():
    options = common.parser(__doc__, size=256, vectors=5800)
    options.add_argument("meshes", nargs="*",
                         help=".vtp, .obj, .ply, .stl or .3ds files (default: bunny, horse and cat)")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    names, cone_pictures, shafts = [], [], []
    for path in arguments.meshes or default_meshes(arguments.data):
        name = os.path.splitext(os.path.basename(path))[0]
        occluders = scenes.label(common.stand_in_room(path, 3.0))
        room = scenes.put_in_room(occluders, arguments.data)
        vectors = common.shadow_vectors(room, light, arguments.vectors)
        cones = common.cone_set(vectors)
        print(f"{name}: {common.summary(cones)}", flush=True)
        cone_pictures.append(common.cone_view(occluders, vectors, cones, 0.5, side_camera(), arguments.size))
        image = common.light_shafts(room, light, cones, "Medium", arguments.size)
        image.SetNumberOfSurfaceLightSamples(64)
        image.Update()
        names.append(name)
        shafts.append(common.pixels(image.GetOutput()))
    common.save(common.table([cone_pictures, shafts], names), os.path.join(arguments.output, "real-meshes.png"))


if __name__ == "__main__":
    main()
