#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A chair in dense fog with one scattering, and with all of them: direct light of the cones, the rest of photon maps."""

import os

import common
import scenes
import shadowcones as sc


def photon_map(room, light, number, sigma_s):
    """Where light that was scattered or reflected before meets walls, chair and fog."""
    photons = sc.vtkPhotonMapFilter()
    photons.SetInputConnection(room.GetOutputPort())
    photons.SetLightConnection(light.GetOutputPort())
    photons.SetNumberOfPhotons(number)
    photons.SetSigmaS(sigma_s)
    photons.SetPhasePresetToRayleigh()
    photons.SetMediumBounds(*scenes.MEDIUM_BOUNDS)
    return photons


def main():
    options = common.parser(__doc__, size=512, vectors=5800)
    options.add_argument("--photons", type=int, default=1000000, help="photons to emit (default: 1000000)")
    options.add_argument("--fog", type=float, default=0.4, help="scattering coefficient of the fog (default: 0.4)")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    occluders = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))
    room = scenes.put_in_room(occluders, arguments.data)
    cones = common.cone_set(common.shadow_vectors(room, light, arguments.vectors))
    image = common.light_shafts(room, light, cones, "Guided", arguments.size)
    image.SetSigmaS(arguments.fog)

    photons = photon_map(room, light, arguments.photons, arguments.fog)
    image.AddPhotonMapConnection(photons.GetOutputPort(0))
    image.AddPhotonMapConnection(photons.GetOutputPort(1))
    image.Update()
    all_light = common.pixels(image.GetOutput())
    points = image.GetOutput().GetPointData()
    for name in ("InScattering", "MultipleScattering", "SurfaceRadiance", "IndirectSurface"):
        print(f"{name}: {common.array(points, name).mean():.4f} W m^-2 sr^-1 on average")
    print(f"{photons.GetOutput(0).GetNumberOfPoints():,} photons on surfaces, "
          f"{photons.GetOutput(1).GetNumberOfPoints():,} in the fog", flush=True)

    # One exposure for both.
    image.SetExposure(image.GetOutput().GetFieldData().GetArray("Exposure").GetTuple1(0))
    image.AutoExposureOff()
    image.RemoveAllPhotonMaps()
    image.Update()
    common.save(common.table([[common.pixels(image.GetOutput()), all_light]], ["One scattering", "All of them"]),
                os.path.join(arguments.output, "multiple-scattering.png"))


if __name__ == "__main__":
    main()
