# SPDX-License-Identifier: BSD-3-Clause
"""The room of yardsticks.py for POV-Ray."""

import os
import resource
import subprocess
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

FADE = 0.001  # POV-Ray fades light by 2 / (1 + (d / fade)^2): the inverse square at any distance that matters
BRIGHTNESS = 4.0  # of the 16 bits of its files


def vector(values):
    return "<" + ", ".join(f"{float(value):.9g}" for value in values) + ">"


def scene_of(room, samples, lights):
    """A wide spotlight of tightness 1 is a lamp whose light falls with the cosine; its place is spread over the disc for
    shadows alone. At 90 degrees POV-Ray loses rays."""
    forward = -room["back"] / (2.0 * np.tan(0.5 * room["angle"]))
    # Radiance 1 of the disc: pi r^2 cos / d^2 of irradiance, of which 1 / (4 pi) is scattered into each direction.
    color = BRIGHTNESS * room["radius"] ** 2 / (8.0 * FADE ** 2)
    points = ",\n".join(vector(p) for p in room["points"])
    triangles = ",\n".join("<%d, %d, %d>" % tuple(t) for t in room["triangles"])
    return f"""#version 3.7;
global_settings {{ assumed_gamma 1.0 }}
camera {{ location {vector(room["position"])} direction {vector(forward)} right {vector(room["right"])} up {vector(room["up"])} }}
light_source {{ {vector(room["lamp"])} color rgb {color:.9g}
  spotlight point_at {vector(room["lamp"] - [0, 1, 0])} radius 89 falloff 89 tightness 1
  area_light {2.0 * room["radius"]} * x, {2.0 * room["radius"]} * z, {lights}, {lights} adaptive 1 circular jitter
  fade_distance {FADE} fade_power 2 media_attenuation on }}
mesh2 {{ vertex_vectors {{ {len(room["points"])},\n{points} }}
  face_indices {{ {len(room["triangles"])},\n{triangles} }}
  pigment {{ color rgb 0 }} finish {{ ambient 0 diffuse 0 }} }}
box {{ {vector(room["bounds"][0])}, {vector(room["bounds"][1])} hollow pigment {{ color rgbt 1 }} finish {{ ambient 0 diffuse 0 }}
  interior {{ media {{ scattering {{ 1, rgb {room["sigma"]} extinction 1 }} method 3 intervals 1 samples {samples} }} }} }}
"""


def render(room, knobs, folder):
    """Pixels, from the lowest row on, and seconds by the processor and the clock."""
    name = os.path.join(folder, "%d-%d" % knobs)
    with open(name + ".pov", "w", encoding="ascii") as file:
        file.write(scene_of(room, *knobs))
    size = room["size"]
    before, clock = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run(["povray", f"+I{name}.pov", f"+O{name}.png", f"+W{size}", f"+H{size}", "-D", "-A", "+FN16", "File_Gamma=1.0",
                    f"+WT{room['threads']}", "-GA"], check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = [after.ru_utime - before.ru_utime, time.perf_counter() - clock]
    reader = vtkPNGReader()
    reader.SetFileName(name + ".png")
    reader.Update()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    values = values if values.ndim == 1 else values[:, 0]
    return values.reshape(size, size) / 65535.0 / BRIGHTNESS, seconds
