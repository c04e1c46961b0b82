#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Under a forest canopy: beams of a Sun without width between 4,000 leaves, as a person sees them."""

import common
import numpy as np
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkPlaneSource

FOREST = (-14, 14, 0, 10, -26, 8)


def trunk(x, z, radius):
    """A trunk that stands on the ground and ends in the crown."""
    wood = vtkCylinderSource()
    wood.SetCenter(x, 4.5, z)
    wood.SetHeight(9.0)
    wood.SetRadius(radius)
    wood.SetResolution(16)
    return common.painted(wood, 0.32, 0.24, 0.17)


def leaves(random, trunks, number):
    """Squares of any direction, thick around the trunks and thin between the crowns."""
    tree = trunks[random.integers(len(trunks), size=number)]
    middle = np.stack([tree[:, 0], np.full(number, 7.6), tree[:, 1]], axis=1) + random.normal(size=(number, 3)) * (1.5, 0.9, 1.5)
    across = random.normal(size=(number, 3))
    across *= random.uniform(0.18, 0.34, (number, 1)) / np.linalg.norm(across, axis=1, keepdims=True)
    along = np.cross(across, random.normal(size=(number, 3)))
    along *= np.linalg.norm(across, axis=1, keepdims=True) / np.linalg.norm(along, axis=1, keepdims=True)
    corners = np.stack([middle - across - along, middle + across - along, middle + across + along, middle - across + along], axis=1)
    return corners.reshape(-1, 3), np.arange(4 * number).reshape(number, 4)


def main():
    options = common.parser(__doc__, 1000)
    options.add_argument("--goal", type=float, default=0.2, help="relative error of a pixel (default: 0.2)")
    options.add_argument("--leaves", type=int, default=4000, help="how many leaves (default: 4,000)")
    arguments = common.parse(options)
    random = np.random.default_rng(7)
    trunks = np.array([(x + random.uniform(-1.2, 1.2), z + random.uniform(-1.2, 1.2))
                       for x in (-10, -6, -2.4, 2.4, 6, 10) for z in (-23, -18, -13, -8, -3)])
    ground = vtkPlaneSource()
    ground.SetOrigin(-14, 0, 8)
    ground.SetPoint1(14, 0, 8)
    ground.SetPoint2(-14, 0, -26)
    meshes = [common.painted(ground, 0.22, 0.20, 0.12), common.painted(leaves(random, trunks, arguments.leaves), 0.15, 0.5, 0.08)]
    meshes += [trunk(x, z, random.uniform(0.14, 0.26)) for x, z in trunks]
    shot = sc.light_shafts(meshes, "sun: direction 0.22,-0.72,0.66 diameter 0 irradiance 800 W/m2 spectrum .55,.7,.85,.97,1,1,1",
                           common.camera_at((0.3, 1.7, 6.5), (-0.4, 3.1, -6.0), 62.0, (0, 1, 0)),
                           (arguments.size, arguments.size * 5 // 8), arguments.goal, medium=FOREST, sigma_s=0.03, asymmetry=0.6)
    shot.save(f"{arguments.output}/canopy.png")
    print(f"wrote {arguments.output}/canopy.png: {shot}")


if __name__ == "__main__":
    main()
