# SPDX-License-Identifier: BSD-3-Clause
"""States and animations in ParaView, in a view without a window: what is saved and loaded again gives the same picture, and time moves lamps.

    xvfb-run -a pvpython Testing/ParaView/states.py --plugin ShadowConesParaView.so --data Data
"""

import argparse
import os
import sys
import tempfile

from paraview import servermanager, simple, smstate
from vtkmodules.util.numpy_support import vtk_to_numpy

SMALL = {"Resolution": [48, 36], "RelativeErrorGoal": 0.1}


def radiance(image, port, moment=None):
    """Every number of an image, at a time."""
    simple.UpdatePipeline(proxy=image, **({} if moment is None else {"time": moment}))
    data = servermanager.Fetch(image, idx=port)
    return vtk_to_numpy(data.GetPointData().GetArray("Radiance"))


def same(one, other):
    return one.shape == other.shape and (one == other).all()


def expect(what, true):
    print(("ok      " if true else "FAILED  ") + what, flush=True)
    if not true:
        sys.exit(1)


def scene(data):
    """A chair and an area light that are Light Shafts, and the chain of filters beside it."""
    mesh = simple.XMLPolyDataReader(registrationName="chair", FileName=[os.path.join(data, "chair.vtp")])
    lamp = simple.AreaLight(registrationName="lamp", Shape="Disc", Center=[0.0, 5.0, 0.5], Normal=[0.0, -1.0, 0.0], Radius=0.4)
    shafts = simple.LightShafts(registrationName="shafts", Input=mesh, Light=lamp, **SMALL)
    shafts.Camera = "Camera"
    shafts.Camera.Position = [3.0, 3.0, 9.0]
    shafts.Camera.FocalPoint = [0.0, 2.0, 0.0]
    image = simple.ScatteringImage(registrationName="image", Input=simple.LabelOccluders(Input=mesh), Light=lamp, Mode="Guided",
                                   PhaseFunction="Henyey Greenstein", PhaseAsymmetry=0.3, SigmaSSpectrum=[0.3, 0.2], **SMALL)
    return lamp, shafts, image


def check_states(data, folder):
    """A .pvsm and a .py give the bytes of the pipeline that they were made of."""
    _, shafts, image = scene(data)
    view = simple.CreateRenderView(ViewSize=[64, 48])
    for source in (shafts, image):
        simple.Show(source, view)  # a script holds what is shown, and what that is made of
    before = radiance(shafts, 2), radiance(image, 0)
    expect("the two images are images", all(values.max() > 0.0 for values in before) and not same(*before))
    for name in ("state.py", "state.pvsm"):
        path = os.path.join(folder, name)
        if name.endswith("py"):
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(smstate.get_state())
        else:
            simple.SaveState(path)
        simple.ResetSession()
        if name.endswith("py"):
            with open(path, encoding="utf-8") as stream:
                exec(compile(stream.read(), path, "exec"), {"__name__": "__main__"})
        else:
            simple.LoadState(path)
        found = simple.FindSource("shafts"), simple.FindSource("image")
        expect(name + " holds both", all(found))
        simple.SetActiveSource(found[0])
        after = radiance(found[0], 2), radiance(found[1], 0)
        expect(name + " gives the same bytes", all(same(*pair) for pair in zip(before, after)))
    simple.ResetSession()


def check_lamp(data):
    """A lamp whose place is keyframed is where the keyframes put it."""
    lamp, shafts, _ = scene(data)
    at = {}
    for x in (-1.0, 0.0, 1.0):
        lamp.Center = [x, 5.0, 0.5]
        at[x] = radiance(shafts, 2).copy()
    expect("the lamp's place counts", not same(at[-1.0], at[1.0]))
    track = simple.GetAnimationTrack("Center", index=0, proxy=lamp)
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=0.0, KeyValues=[-1.0]), simple.CompositeKeyFrame(KeyTime=1.0, KeyValues=[1.0])]
    animation = simple.GetAnimationScene()
    animation.PlayMode = "Sequence"
    animation.StartTime, animation.EndTime = 0.0, 10.0
    for moment, x in ((0.0, -1.0), (5.0, 0.0), (10.0, 1.0)):
        animation.AnimationTime = moment
        expect(f"the lamp at time {moment}", same(radiance(shafts, 2), at[x]))
    simple.ResetSession()


def check_sun(data):
    """The Sun of a Sun Path moves with the time of the scene."""
    mesh = simple.XMLPolyDataReader(FileName=[os.path.join(data, "chair.vtp")])
    sun = simple.SunPath(Latitude=48.0, Longitude=0.0, Start="2024-06-21T00:00:00Z", End="2024-06-22T00:00:00Z", Step=120.0,
                         Up=[0.0, 1.0, 0.0], North=[0.0, 0.0, -1.0])
    shafts = simple.LightShafts(Input=mesh, Light=sun, **SMALL)
    sun.UpdatePipelineInformation()
    hour = 3600.0
    expect("time steps are those of the path", list(sun.TimestepValues) == [2.0 * hour * k for k in range(13)])
    morning, noon, again = (radiance(shafts, 2, moment * hour).copy() for moment in (8.0, 12.0, 8.0))
    expect("the Sun moves", not same(morning, noon) and noon.max() > 0.0)
    expect("and comes again", same(morning, again))
    simple.ResetSession()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", required=True, help="ShadowConesParaView.so")
    parser.add_argument("--data", required=True, help="folder of the meshes")
    arguments = parser.parse_args()
    simple.LoadPlugin(os.path.abspath(arguments.plugin), remote=False, ns=simple.__dict__)
    check_lamp(arguments.data)
    check_sun(arguments.data)
    with tempfile.TemporaryDirectory() as folder:
        check_states(arguments.data, folder)


if __name__ == "__main__":
    main()
