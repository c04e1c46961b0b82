#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A mesh, its lamp, and the picture of its light shafts where the picture's camera looks, seen from beside that camera."""

import os

import common
import scenes
import shadowcones as sc
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer


def main():
    options = common.parser(__doc__, size=500)
    options.add_argument("--mesh", help="a mesh (vtp, obj, ply, stl, 3ds; default: the chair of Data)")
    arguments = common.parse(options)
    mesh = common.read_mesh(arguments.mesh or os.path.join(arguments.data, "chair.vtp"))

    shafts = sc.vtkLightShafts()
    shafts.SetInputData(mesh)
    shafts.SetResolution(arguments.size, round(0.75 * arguments.size))
    shafts.Update()
    image = shafts.GetOutputDataObject(2)
    scenes.write_png(image, os.path.join(arguments.output, "light-shafts-image.png"))

    # The picture's camera stands in the field data of the image: this one looks at the same point, from 30 degrees beside it.
    field = image.GetFieldData()
    camera = vtkCamera()
    camera.SetPosition(field.GetArray("CameraPosition").GetTuple3(0))
    camera.SetFocalPoint(field.GetArray("CameraFocalPoint").GetTuple3(0))
    camera.SetViewUp(field.GetArray("CameraViewUp").GetTuple3(0))
    camera.Azimuth(30.0)
    camera.SetViewAngle(1.3 * field.GetArray("CameraViewAngle").GetTuple1(0))

    renderer = vtkRenderer()
    picture = common.add_actor(renderer, shafts.GetOutputPort(0), common.GREY, ambient=1.0)
    picture.GetMapper().ScalarVisibilityOn()
    common.add_actor(renderer, mesh, common.GREY, ambient=0.3)
    common.add_actor(renderer, shafts.GetOutputPort(1), (1.0, 0.8, 0.3), ambient=1.0)
    common.save(common.render(renderer, camera, arguments.size), os.path.join(arguments.output, "light-shafts.png"))


if __name__ == "__main__":
    main()
