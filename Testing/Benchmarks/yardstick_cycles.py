# SPDX-License-Identifier: BSD-3-Clause
"""The room of yardsticks.py in Cycles.

Blender runs it: blender -b --factory-startup -P yardstick_cycles.py -- ROOM.npz OUT.npz SAMPLES...
"""

import json
import os
import sys
import tempfile
import time

import bpy
import numpy as np
from mathutils import Matrix


def add_mesh(name, points, triangles, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points.tolist(), [], triangles.tolist())
    mesh.materials.append(material)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new(name, mesh))


def material_of(name, node, socket, values):
    """One node, and nothing else, on a socket of the material's output."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    shader = nodes.new(node)
    for key, value in values.items():
        shader.inputs[key].default_value = value
    output = nodes.new("ShaderNodeOutputMaterial")
    material.node_tree.links.new(shader.outputs[0], output.inputs[socket])
    return material


def add_medium(bounds, sigma):
    low, high = bounds
    corners = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)])
    faces = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
    fog = material_of("fog", "ShaderNodeVolumeScatter", "Volume",
                      {"Color": (1.0, 1.0, 1.0, 1.0), "Density": sigma, "Anisotropy": 0.0})
    add_mesh("medium", corners, faces, fog)


def add_lamp(center, radius, radiance, bounces):
    """A disc that faces down. Its radiance is energy / (pi size^2)."""
    lamp = bpy.data.lights.new("lamp", "AREA")
    lamp.shape = "DISK"
    lamp.size = 2.0 * radius
    lamp.energy = radiance * np.pi * lamp.size ** 2
    lamp.cycles.max_bounces = bounces
    thing = bpy.data.objects.new("lamp", lamp)
    thing.matrix_world = Matrix(((1, 0, 0, center[0]), (0, 0, 1, center[1]), (0, -1, 0, center[2]), (0, 0, 0, 1)))
    thing.visible_camera = False
    bpy.context.scene.collection.objects.link(thing)


def add_camera(position, right, up, back, angle):
    camera = bpy.data.cameras.new("camera")
    camera.angle = angle
    thing = bpy.data.objects.new("camera", camera)
    thing.matrix_world = Matrix([[right[k], up[k], back[k], position[k]] for k in range(3)] + [[0, 0, 0, 1]])
    bpy.context.scene.collection.objects.link(thing)
    bpy.context.scene.camera = thing


def set_up(size, threads, bounces, seed):
    """Rays through pixel centres, every sample spent."""
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("dark")
    scene.world.color = (0.0, 0.0, 0.0)
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.resolution_percentage = 100
    scene.render.threads_mode = "FIXED"
    scene.render.threads = threads
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = False
    cycles.use_denoising = False
    cycles.max_bounces = cycles.volume_bounces = cycles.diffuse_bounces = bounces
    cycles.transparent_max_bounces = 8 + 4 * bounces  # the border of the fog is one whenever a path passes it
    cycles.seed = seed
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.light_sampling_threshold = 0.0
    cycles.filter_width = 0.01


def render(samples, folder):
    """Pixels, from the lowest row on, and seconds by the processor and the clock."""
    scene = bpy.context.scene
    scene.cycles.samples = samples
    scene.render.filepath = os.path.join(folder, f"{samples}.exr")
    processor, clock = time.process_time(), time.perf_counter()
    bpy.ops.render.render(write_still=True)
    seconds = [time.process_time() - processor, time.perf_counter() - clock]
    image = bpy.data.images.load(scene.render.filepath)
    side = scene.render.resolution_x
    return np.array(image.pixels[:], dtype=np.float32).reshape(side, side, 4)[:, :, 0], seconds


def main():
    room_file, out_file, *samples = sys.argv[sys.argv.index("--") + 1:]
    room = np.load(room_file)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    grey = material_of("grey", "ShaderNodeBsdfDiffuse", "Surface", {"Color": 3 * (float(room["reflectance"]),) + (1.0,)})
    add_mesh("room", room["points"], room["triangles"], grey)
    add_medium(room["bounds"], float(room["sigma"]))
    add_lamp(room["lamp"], float(room["radius"]), 1.0, int(room["bounces"]))
    add_camera(room["position"], room["right"], room["up"], room["back"], float(room["angle"]))
    set_up(*(int(room[name]) for name in ("size", "threads", "bounces", "seed")))
    with tempfile.TemporaryDirectory() as folder:
        render(1, folder)  # what is loaded once is loaded then
        images, seconds = zip(*(render(int(count), folder) for count in samples))
    np.savez(out_file, images=np.array(images), seconds=np.array(seconds))
    print(json.dumps({"samples": samples, "seconds": [s[0] for s in seconds]}))


main()
