#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What rivals make of one scene, and how far each is off, on one sheet; and VTK's own shadow maps. Needs a display."""

import glob
import os
import re
import subprocess
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass, vtkLightsPass, vtkOpaquePass, vtkRenderPassCollection, vtkSequencePass, vtkShadowMapBakerPass, vtkShadowMapPass)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
import common  # noqa: E402
import scenes  # noqa: E402

# As the program names them.
ROWS = (
    (("rays everywhere", "16 a place", 256), ("shadow buffer", "1 x 1024^2"), ("shadow buffer, soft", "1 x 512^2"),
     ("shadow buffers", "16 x 512^2"), ("deep shadow maps", "1 x 256^2, 4^2 rays"), ("voxels", "33^3, 16 rays")),
    (("octree", "depth 6, 32 rays"), ("projection volumes", "4 points"), ("shadow photons", "50000 paths, 24 near"),
     ("path tracing, even angle", "64 a pixel"), ("cones, buffers inside", "16 x 512^2"), ("ours: Guided", "goal 1 %")))
FULL = 0.15  # of the mean: the difference that has the full colour


def rendered(program, scene, size, name, setting, places=64):
    """The image of one rival, by the program."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "--scene", scene, "--size", str(size), "--places", str(places), "--rows", f"{name}, {setting}",
                        "--pixels", "16", "--samples", "64", "--images", folder], check=True, stdout=subprocess.DEVNULL)
        wanted = re.sub("[^A-Za-z0-9]+", "-", f"{name} {setting}").strip("-") + ".vti"
        reader = vtkXMLImageDataReader()
        reader.SetFileName(next(file for file in glob.glob(f"{folder}/*.vti") if file.endswith(wanted)))
        reader.Update()
        return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(size, size)


def grey(values, white):
    """Fog as a picture."""
    shade = 255 * np.clip(values / white, 0, 1) ** (1 / 2.2)
    return np.repeat(shade.round().astype(np.uint8)[:, :, np.newaxis], 3, axis=2)


def difference(values, truth):
    """Orange where there is too much light, blue where too little."""
    share = np.clip((values - truth) / truth.mean() / FULL, -1, 1)[:, :, np.newaxis]
    color = np.where(share > 0, np.array(common.ORANGE), np.array(common.DARK_BLUE))
    return (255 * (1 - np.abs(share) * (1 - color))).round().astype(np.uint8)


def by_shadow_maps(size):
    """The chair in its room by VTK's own pass: hard shadows of a positional lamp on surfaces, and no fog."""
    renderer = vtkRenderer()
    room = scenes.put_in_room(scenes.label(scenes.read(os.path.join(scenes.DATA, "chair.vtp"))))
    common.add_actor(renderer, room, common.GREY)
    lamp = vtkLight()
    lamp.SetPosition(0.0, 5.45, 0.0)
    lamp.SetFocalPoint(0.0, 0.0, 0.0)
    lamp.PositionalOn()
    lamp.SetConeAngle(60.0)
    renderer.AutomaticLightCreationOff()
    renderer.AddLight(lamp)

    def sequence(*passes):
        collection = vtkRenderPassCollection()
        for item in passes:
            collection.AddItem(item)
        result = vtkSequencePass()
        result.SetPasses(collection)
        return result

    def through_camera(item):
        result = vtkCameraPass()
        result.SetDelegatePass(item)
        return result

    baker = vtkShadowMapBakerPass()
    baker.SetResolution(1024)
    baker.SetOpaqueSequence(through_camera(sequence(vtkLightsPass(), vtkOpaquePass())))
    shadows = vtkShadowMapPass()
    shadows.SetShadowMapBakerPass(baker)
    shadows.SetOpaqueSequence(sequence(vtkLightsPass(), vtkOpaquePass()))
    renderer.SetPass(through_camera(sequence(baker, shadows)))
    return common.render(renderer, scenes.front_camera(), size)


def main():
    options = common.parser(__doc__, size=150)
    options.add_argument("--program", default="build/bin/rivals", help="default: build/bin/rivals")
    options.add_argument("--scene", default="tree", help="scene of the program (default: tree)")
    arguments = common.parse(options)
    truth = None
    strips = []
    for row in ROWS:
        titles, pictures, differences = [], [], []
        for name, setting, *places in row:
            values = rendered(arguments.program, arguments.scene, arguments.size, name, setting, *places)
            truth = values if truth is None else truth
            white = np.percentile(truth, 97)
            titles.append(name if places else f"{name}: {setting}")
            pictures.append(grey(values, white))
            differences.append(difference(values, truth))
        titles = [title if title != "rays everywhere" else "converged, by rays" for title in titles]
        strips.append(common.table([pictures, differences], titles))
    entries = ((common.ORANGE, f"too bright by {FULL:.0%} of the mean or more"), (common.DARK_BLUE, "too dark by as much"))
    sheet = common.stack(*strips, common.key(entries, strips[0].shape[1]))
    common.save(sheet, f"{arguments.output}/rivals-{arguments.scene}.png", levels=64)
    common.save(by_shadow_maps(300), f"{arguments.output}/rivals-shadow-map-pass.png", levels=64)


if __name__ == "__main__":
    main()
