# SPDX-License-Identifier: BSD-3-Clause
"""The whole chain in ParaView: cones and light shafts around a slatted chair.

Run it with the pvpython that the plugin was built for:

    xvfb-run -a pvpython Examples/ParaView/chair.py --plugin <build folder>/lib/paraview-5.11/plugins/ShadowConesParaView/ShadowConesParaView.so
"""

import argparse
import os

from paraview import simple

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")

# Walls have a "Reflectance" of seven wavelengths; appending keeps the arrays that both have.
PAINT = """
import numpy
output.CellData.append(numpy.full((inputs[0].GetNumberOfCells(), 7), 0.6, dtype=numpy.float32), "Reflectance")
"""


def read(path):
    if not os.path.exists(path):
        raise SystemExit(f"There is no file {path}; --data names the folder of the meshes")
    return simple.XMLPolyDataReader(FileName=[path])


def chain(data, size):
    """Every step from the mesh to the image."""
    painted = simple.ProgrammableFilter(Input=read(os.path.join(data, "chair.vtp")), Script=PAINT, CopyArrays=True)
    occluders = simple.LabelOccluders(Input=painted)
    room = simple.AppendGeometry(Input=[occluders, read(os.path.join(data, "cornell-box.vtp"))])

    light = simple.AreaLight(Shape="Disc", Center=[0.0, 5.49, 0.0], Normal=[0.0, -1.0, 0.0], Radius=0.5)
    vectors = simple.ShadowVectors(Input=room, Light=light, TargetNumberOfVectors=5800)
    cones = simple.ConeSet(
        Input=simple.OutputPort(vectors, "Shadow Vectors"), PhotonPaths=simple.OutputPort(vectors, "Photon Paths"),
        Mesh=room)  # cones that are proved to hold all of the shadow

    image = simple.ScatteringImage(Input=room, Light=light, ConeSet=simple.OutputPort(cones, "Cone Set"))
    image.Camera = "Camera"
    image.Camera.Position = [0.0, 2.75, 12.5]
    image.Camera.FocalPoint = [0.0, 2.75, 0.0]
    image.Camera.ViewAngle = 32.0
    image.Resolution = [size, size]
    image.Mode = "Guided"
    image.SigmaS = 0.12
    image.MediumBounds = [-2.75, 2.75, 0.0, 5.2, -2.75, 2.75]
    return occluders, light, vectors, cones, image


def show_cones(occluders, light, vectors, cones, path):
    """Cones in blue, cut one unit from their base; base discs in red; shadow vectors in green."""
    view = simple.CreateRenderView(ViewSize=[900, 900], OrientationAxesVisibility=0)
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    geometry = simple.ConeSetGeometry(Input=simple.OutputPort(cones, "Cone Set"), Length=1.0)
    arrows = simple.Glyph(
        Input=simple.OutputPort(vectors, "Shadow Vectors"), GlyphType="Line", OrientationArray=["POINTS", "Direction"],
        ScaleArray=["POINTS", "No scale array"], ScaleFactor=0.08, GlyphMode="All Points")
    arrows.GlyphTransform.Translate = [0.5, 0.0, 0.0]  # a line glyph is centred, and vectors start at their point
    for port, color, opacity in (
            (occluders, [0.75, 0.72, 0.66], 1.0),
            (light, [1.0, 0.85, 0.3], 1.0),
            (simple.OutputPort(geometry, "Cones"), [0.15, 0.35, 0.95], 0.06),
            (simple.OutputPort(geometry, "Base Discs"), [0.9, 0.1, 0.1], 0.8),
            (arrows, [0.0, 0.6, 0.1], 1.0)):
        display = simple.Show(port, view)
        display.ColorArrayName = ["POINTS", ""]
        display.DiffuseColor = display.AmbientColor = color
        display.Opacity = opacity
    view.CameraPosition = [5.5, 4.6, 8.5]
    view.CameraFocalPoint = [0.0, 1.9, 0.0]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    view.CameraViewAngle = 30.0
    simple.Render(view)
    simple.SaveScreenshot(path, view)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", help="ShadowConesParaView.so; not needed where ParaView loads it by itself")
    parser.add_argument("--data", default=DATA, help="folder of the meshes (default: Data of this project)")
    parser.add_argument("--output", default="output", help="folder to write to (default: output)")
    parser.add_argument("--size", type=int, default=256, help="width and height of the image in pixels (default: 256)")
    arguments = parser.parse_args()
    if arguments.plugin:
        simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=simple.__dict__)
    os.makedirs(arguments.output, exist_ok=True)

    occluders, light, vectors, cones, image = chain(arguments.data, arguments.size)
    simple.UpdatePipeline(proxy=image)
    if image.PointData.GetArray("RGB") is None:
        raise SystemExit("The chain gave no image: its messages stand above")
    simple.SaveData(os.path.join(arguments.output, "scattering.vti"), proxy=image)
    simple.SaveData(os.path.join(arguments.output, "scattering.png"), proxy=image)
    show_cones(occluders, light, vectors, cones, os.path.join(arguments.output, "cones.png"))
    print(f"{vectors.GetDataInformation(0).GetNumberOfPoints()} shadow vectors, "
          f"{cones.GetDataInformation(0).GetNumberOfPoints()} cones; written to {arguments.output}: "
          "scattering.vti, scattering.png, cones.png")


if __name__ == "__main__":
    main()
