# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's macros do what they say, in a view without a window.

    xvfb-run -a pvpython Testing/ParaView/macros.py --plugin ShadowConesParaView.so --data Data
"""

import argparse
import os
import runpy
import sys

from paraview import simple

MACROS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Modules", "ParaViewPlugin", "macros")


def expect(what, true):
    print(("ok      " if true else "FAILED  ") + what, flush=True)
    if not true:
        sys.exit(1)


def run(name):
    return runpy.run_path(os.path.join(MACROS, name), run_name="__main__")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", required=True, help="ShadowConesParaView.so")
    parser.add_argument("--data", required=True, help="folder of the meshes")
    arguments = parser.parse_args()
    simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=simple.__dict__)
    view = simple.CreateRenderView(ViewSize=[400, 200])
    mesh = simple.XMLPolyDataReader(FileName=[os.path.join(arguments.data, "chair.vtp")])
    shafts = simple.LightShafts(Input=mesh, Resolution=[40, 40], RelativeErrorGoal=0.2)
    picture = simple.Show(shafts, view)
    expect("the picture is shown as it is", picture.Representation == "Picture")

    view.CameraPosition, view.CameraFocalPoint = [5.0, 4.0, 9.0], [0.0, 2.0, 0.0]
    simple.SetActiveSource(mesh)  # not the image: the last one is taken
    run("look_as_i_do.py")
    expect("position and focal point are the view's",
           list(shafts.Camera.Position) == [5.0, 4.0, 9.0] and list(shafts.Camera.FocalPoint) == [0.0, 2.0, 0.0])
    expect("as many pixels in the shape of the view", list(shafts.Resolution) == [57, 28])
    view.CameraPosition = [-5.0, 4.0, 9.0]
    interactor = view.SMProxy.GetInteractor()
    if interactor is not None:
        interactor.InvokeEvent("EndInteractionEvent")
        expect("it follows", list(shafts.Camera.Position) == [-5.0, 4.0, 9.0])
        run("look_as_i_do.py")
        view.CameraPosition = [0.0, 4.0, 9.0]
        interactor.InvokeEvent("EndInteractionEvent")
        expect("and stops", list(shafts.Camera.Position) == [-5.0, 4.0, 9.0])

    simple.SetActiveSource(mesh)
    for preset, shape in (("ceiling_panel.py", "Rectangle"), ("bulb.py", "Sphere"), ("sun_at_three.py", "Sun")):
        simple.SetActiveSource(mesh)
        lamp = run(preset)["lamp"]
        expect(preset, lamp.Shape == shape)
        if shape == "Sun":
            expect("the Sun shines down", lamp.Normal[1] < -0.5)
        else:
            expect("it hangs above the chair", lamp.Center[1] > 2.7)

    occluders = simple.LabelOccluders(Input=mesh)
    simple.UpdatePipeline(proxy=occluders)
    simple.SetActiveSource(occluders)
    run("shadow_cones_colors.py")
    display = simple.GetDisplayProperties(occluders, view)
    expect("occluders have their colours", list(display.ColorArrayName) == ["CELLS", "OccluderId"])
    expect("of the colour map", len(simple.GetColorTransferFunction("OccluderId").IndexedColors) == 27)


if __name__ == "__main__":
    main()
