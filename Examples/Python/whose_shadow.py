#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whose shadow is it? Five buildings, and the name of the one that hides most of the Sun at every place of the ground."""

import common
import numpy as np
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkRenderer

# Metres: x is east, y is north.
BOXES = {"office": (-34, -20, -6, 10, 0, 58), "hall": (-8, 22, 12, 30, 0, 16), "hotel": (26, 38, -4, 8, 0, 44),
         "school": (-12, 12, -22, -10, 0, 12)}
COLORS = {"office": common.DARK_BLUE, "hall": common.ORANGE, "hotel": common.TEAL, "school": common.PURPLE,
          "chimney": common.VERMILION}


def buildings():
    """The meshes by their names."""
    meshes = {}
    for name, bounds in BOXES.items():
        meshes[name] = vtkCubeSource()
        meshes[name].SetBounds(*bounds)
    chimney = vtkCylinderSource()
    chimney.SetRadius(2.2)
    chimney.SetHeight(52.0)
    chimney.SetResolution(48)
    meshes["chimney"] = common.turned(chimney, (-14, 44, 26), 90.0)
    return meshes


def main():
    options = common.parser(__doc__, 1400)
    options.add_argument("--cell", type=float, default=0.4, help="edge of a cell of the ground in metres (default: 0.4)")
    arguments = common.parse(options)
    meshes = buildings()
    ground = vtkPlaneSource()
    for set_corner, corner in ((ground.SetOrigin, (-48, -60, 0)), (ground.SetPoint1, (104, -60, 0)), (ground.SetPoint2, (-48, 52, 0))):
        set_corner(*corner)
    ground.SetResolution(round(152 / arguments.cell), round(112 / arguments.cell))
    answered = sc.shadow_of(ground, meshes, "sun: azimuth 292 altitude 36", cells=True)
    renderer = vtkRenderer()
    common.paint(renderer, answered, "OccluderId", common.category_table([COLORS[name] for name in meshes]), cells=True)
    size, ids, centers = arguments.size, common.array(answered.GetCellData(), "OccluderId"), common.centers(answered)
    for number, (name, mesh) in enumerate(meshes.items()):
        actor = common.add_actor(renderer, mesh, 0.35 + 0.65 * np.array(COLORS[name]), ambient=0.35)
        x0, x1, _, y1, _, z1 = actor.GetBounds()
        common.add_label(renderer, name, ((x0 + x1) / 2, y1, z1 + 3), size // 45)
        own = centers[ids == number]
        far = np.linalg.norm(own[:, :2] - ((x0 + x1) / 2, y1), axis=1)
        place = own[far >= np.quantile(far, 0.6)].mean(axis=0)  # where no building stands in front
        common.add_label(renderer, name, place + (0, 0, 1), size // 60, (1, 1, 1) if sum(COLORS[name]) < 1.2 else common.INK)
    picture = common.render(renderer, common.camera_at((30, -190, 170), (26, -2, 14), 31.0), size, size * 9 // 16)
    title = common.text("Whose shadow is it? The building that hides most of the Sun", size, common.legend_line(size) * 3 // 2)
    strip = common.key([(COLORS[name], f"shadow of the {name}") for name in meshes] + [((0.93, 0.93, 0.91), "lit")], size)
    common.save(common.stack(title, picture, strip), f"{arguments.output}/whose-shadow.png", 64)


if __name__ == "__main__":
    main()
