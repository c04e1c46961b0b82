#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The chair's shadow as a volume: filled once from the cones, then rendered, sliced and saved.

Writes visibility-volume.vti, the volume with its bricks, and visibility-volume.png, the shadow in space and a cut
through it. With --window the volume turns in a window of its own instead. Drawing needs a display."""

import os

import common
import numpy as np
import scenes
import shadowcones as sc
import vtkmodules.vtkInteractionStyle  # what the mouse does in the window
import vtkmodules.vtkRenderingVolumeOpenGL2  # volumes on the graphics card
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction, vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter
from vtkmodules.vtkRenderingCore import (
    vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor, vtkVolume,
    vtkVolumeProperty)
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper


def visibility_volume(occluders, light, vectors, number):
    """The share of the light that is visible in the room, on a grid with `number` points along each side."""
    source = common.shadow_vectors(occluders, light, vectors)
    source.SetStorageToHitPoint()
    cones = sc.vtkConeSetFilter()
    cones.SetInputConnection(source.GetOutputPort(0))
    cones.SetPhotonPathConnection(source.GetOutputPort(1))
    cones.SetTuningToConservative()
    volume = sc.vtkVisibilityVolume()
    volume.SetInputConnection(cones.GetOutputPort())
    volume.SetLightConnection(light.GetOutputPort())
    volume.SetMeshConnection(occluders.GetOutputPort())
    volume.SetDimensions(number, number, number)
    volume.SetNumberOfLightSamples(64)  # 16 do for images; a cut shows the noise of every point
    volume.SetBounds(*scenes.MEDIUM_BOUNDS)
    volume.Update()
    return volume


def report(volume):
    """One line on what was filled."""
    points = volume.GetOutput().GetPointData()
    field = volume.GetOutput().GetFieldData()
    bricks = field.GetArray("BrickCells")
    classes = common.array(points, "ShadowClass")
    print(f"{classes.size:,} points, {np.mean(common.array(points, 'Marked')):.1%} asked for with "
          f"{field.GetArray('NumberOfOcclusionRays').GetTuple1(0):,.0f} rays, {np.mean(classes == 1):.1%} in penumbra, "
          f"{np.mean(classes == 2):.1%} in umbra, {bricks.GetNumberOfTuples() if bricks else 0:,} cells refined",
          flush=True)


def add_shadow(renderer, volume):
    """The shadow as dark smoke: what is lit is clear."""
    mapper = vtkSmartVolumeMapper()
    mapper.SetInputConnection(volume.GetOutputPort())
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0.0, 0.9)
    opacity.AddPoint(0.5, 0.25)
    opacity.AddPoint(1.0, 0.0)
    color = vtkColorTransferFunction()
    color.AddRGBPoint(0.0, 0.05, 0.07, 0.25)
    color.AddRGBPoint(1.0, 0.95, 0.75, 0.4)
    look = vtkVolumeProperty()
    look.SetScalarOpacity(opacity)
    look.SetScalarOpacityUnitDistance(0.5)
    look.SetColor(color)
    look.SetInterpolationTypeToLinear()
    shadow = vtkVolume()
    shadow.SetMapper(mapper)
    shadow.SetProperty(look)
    renderer.AddVolume(shadow)


def add_cut(renderer, volume):
    """A plane through the volume, dark blue in umbra and yellow where all of the lamp is seen."""
    plane = vtkPlane()
    plane.SetNormal(1.0, 0.0, 0.0)
    plane.SetOrigin(0.003, 0.0, 0.0)
    cut = vtkCutter()
    cut.SetCutFunction(plane)
    cut.SetInputConnection(volume.GetOutputPort())
    common.paint(renderer, cut.GetOutputPort(), "Visibility", common.color_table(0.0, 1.0))


def view(*position):
    """A camera that looks at the chair and its shadow."""
    return common.camera_at(position, (0.0, 1.6, 0.0), 24.0, (0.0, 1.0, 0.0))


def scene_of(occluders, volume, add):
    """The chair with the volume or the cut."""
    renderer = vtkRenderer()
    common.add_actor(renderer, occluders.GetOutputPort(), common.GREY, ambient=0.4)
    add(renderer, volume)
    return renderer


def show_in_window(occluders, volume, size):
    """The volume to be turned with the mouse, until the window is closed."""
    renderer = scene_of(occluders, volume, add_shadow)
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetActiveCamera(view(4.5, 3.6, 10.0))
    window = vtkRenderWindow()
    window.SetSize(2 * size, 2 * size)
    window.SetWindowName("The visible share of the lamp")
    window.AddRenderer(renderer)
    renderer.ResetCameraClippingRange()
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    window.Render()
    interactor.Start()


def main():
    options = common.parser(__doc__, size=700, vectors=20000)
    options.add_argument("--points", type=int, default=65, help="points along a side of the volume (default: 65)")
    options.add_argument("--window", action="store_true", help="show the volume in a window, and write no picture")
    arguments = common.parse(options)
    light = scenes.ceiling_light()
    chair = scenes.label(scenes.read(os.path.join(arguments.data, "chair.vtp")))
    volume = visibility_volume(chair, light, arguments.vectors, arguments.points)
    report(volume)
    writer = vtkXMLImageDataWriter()
    writer.SetInputConnection(volume.GetOutputPort())
    writer.SetFileName(os.path.join(arguments.output, "visibility-volume.vti"))
    writer.Write()
    print(f"wrote {writer.GetFileName()}")
    if arguments.window:
        show_in_window(chair, volume, arguments.size)
        return
    pictures = [common.render(scene_of(chair, volume, add_shadow), view(4.5, 3.6, 10.0), arguments.size),
                common.render(scene_of(chair, volume, add_cut), view(11.0, 2.0, 0.0), arguments.size)]
    picture = common.table([pictures], ["the shadow in space, as smoke", "a cut through it"])
    strip = common.legend(common.color_table(0.0, 1.0), "Visible share of the lamp", picture.shape[1], marks=6, form="{:.1f}")
    common.save(common.stack(picture, strip), os.path.join(arguments.output, "visibility-volume.png"), 64)


if __name__ == "__main__":
    main()
