#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's own window on a screen in memory: events are played in it, and what it shows is looked at.

A mesh is opened, Apply is pressed, the menu Filters > Shadow Cones > Light Shafts is opened and clicked, and Apply pressed again. The
test passes when the view shows what pvpython shows of the same filter.
"""

import argparse
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")

TRUTH = """
from paraview import simple
simple.LoadPlugin({plugin!r}, remote=False, ns=simple.__dict__)
view = simple.CreateRenderView(ViewSize=[{width}, {height}])
mesh = simple.XMLPolyDataReader(FileName=[{mesh!r}])
simple.Show(mesh, view)
simple.ResetCamera(view)
shafts = simple.LightShafts(Input=mesh)
simple.Hide(mesh, view)
for port in (0, 1):
    simple.Show(simple.OutputPort(shafts, port), view)
simple.SaveScreenshot({path!r}, view)
"""


class Window:
    """ParaView with the plugin on a screen of its own, which ends with the block."""

    def __init__(self, paraview, plugin, events, mesh, size=(1400, 900)):
        self.folder = tempfile.mkdtemp()
        self.log = os.path.join(self.folder, "log")
        read, write = os.pipe()
        self.screen = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{size[0]}x{size[1]}x24", "-noreset", "-fbdir", self.folder],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as answer:
            self.display = ":" + answer.readline().strip()
        # No settings are read and none written: every run is the first one, and no one's own is changed.
        self.environment = {**os.environ, "DISPLAY": self.display, "HOME": self.folder, "VTK_SMP_BACKEND_IN_USE": "STDThread"}
        with open(self.log, "w", encoding="utf-8") as log:
            self.program = subprocess.Popen(
                [paraview, "-dr", f"--plugin-search-paths={os.path.dirname(plugin)}",
                 f"--plugins={os.path.splitext(os.path.basename(plugin))[0]}", f"--data={mesh}", f"--test-script={events}",
                 f"--test-directory={self.folder}"],
                env=self.environment, stdout=log, stderr=log)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for process, end in ((self.program, signal.SIGKILL), (self.screen, signal.SIGTERM)):
            if process.poll() is None:
                process.send_signal(end)
            process.wait()
        shutil.rmtree(self.folder)

    def frame(self):
        """What the screen shows: height x width x 3 bytes, the top row first. The screen's memory is a file of xwd's form."""
        data = np.fromfile(os.path.join(self.folder, "Xvfb_screen0"), dtype=np.uint8)
        header = np.frombuffer(data[:100].tobytes(), dtype=">u4")
        first, width, height, line, colors = header[0], header[4], header[5], header[12], header[19]
        pixels = data[first + 12 * colors:][:line * height].reshape(height, line)[:, :4 * width].reshape(height, width, 4)
        return pixels[:, :, 2::-1]


def truth_of(window, pvpython, plugin, mesh, shape):
    """The same scene of pvpython, of that height and width."""
    script, path = os.path.join(window.folder, "truth.py"), os.path.join(window.folder, "truth.png")
    with open(script, "w", encoding="utf-8") as stream:
        stream.write(TRUTH.format(plugin=plugin, mesh=mesh, path=path, width=shape[1], height=shape[0]))
    subprocess.run([pvpython, script], check=True, timeout=200, stdout=subprocess.DEVNULL, env=window.environment)
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(shape[0], shape[1], -1)[::-1, :, :3]


def view_of(frame):
    """What stands inside the blue frame of the active view; None where there is no such frame."""
    blue = (frame[:, :, 2] > 200) & (frame[:, :, :2].max(axis=2) < 20)
    rows, columns = np.flatnonzero(blue.sum(axis=1) > 300), np.flatnonzero(blue.sum(axis=0) > 300)
    if len(rows) < 2 or len(columns) < 2:
        return None
    return frame[rows[0] + 5:rows[-1] - 4, columns[0] + 5:columns[-1] - 4]


def shows_picture(view):
    """Whether most of a view is grey, from dark to bright: the lamp is white, and the view's ground and the mesh are not."""
    if view is None or view.size == 0:
        return False
    grey = np.ptp(view.astype(int), axis=2) <= 2
    return grey.mean() > 0.4 and np.percentile(view[grey][:, 0], 2) < 50 and np.percentile(view[grey][:, 0], 98) > 120


def blocks(picture, rows=24, columns=32):
    """Means over blocks, of the green channel."""
    edges = [np.linspace(0, n, m + 1).astype(int) for n, m in zip(picture.shape, (rows, columns))]
    sums = np.add.reduceat(np.add.reduceat(picture[:, :, 1].astype(float), edges[0][:-1], axis=0), edges[1][:-1], axis=1)
    return sums / np.outer(np.diff(edges[0]), np.diff(edges[1]))


def save(frame, path):
    image = vtkImageData()
    image.SetDimensions(frame.shape[1], frame.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(frame[::-1]).reshape(-1, 3), deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--paraview", required=True, help="folder of paraview and pvpython")
    parser.add_argument("--plugin", required=True, help="ShadowConesParaView.so")
    parser.add_argument("--mesh", default=os.path.join(ROOT, "Data", "chair.vtp"))
    parser.add_argument("--events", default=os.path.join(HERE, "events-light-shafts.xml"))
    parser.add_argument("--seconds", type=float, default=200.0, help="how long to wait for the picture (default: 200)")
    parser.add_argument("--save", help="a PNG of the screen at the end")
    arguments = parser.parse_args()
    plugin, mesh = os.path.abspath(arguments.plugin), os.path.abspath(arguments.mesh)
    start = time.monotonic()
    with Window(os.path.join(arguments.paraview, "paraview"), plugin, os.path.abspath(arguments.events), mesh) as window:
        view = None
        while not shows_picture(view) and time.monotonic() - start < arguments.seconds and window.program.poll() is None:
            time.sleep(0.5)
            view = view_of(window.frame())
        time.sleep(1.0)  # the rest of the window is drawn
        frame = window.frame()
        if arguments.save:
            save(frame, arguments.save)
        seconds = time.monotonic() - start
        difference = None
        if shows_picture(view_of(frame)):
            view = view_of(frame)
            truth = truth_of(window, os.path.join(arguments.paraview, "pvpython"), plugin, mesh, view.shape)
            difference = np.abs(blocks(view) - blocks(truth))
        with open(window.log, encoding="utf-8", errors="replace") as log:
            said = [line for line in log if "ERR|" in line or "FATL|" in line]
    print("".join(said[:10]), end="")
    if difference is None:
        sys.exit(f"After {seconds:.0f} s the view shows no picture")
    # The legend and the axes are the window's own; everywhere else it is the same to a level.
    print(f"{seconds:.1f} s; of {difference.size} blocks {(difference < 3.0).mean():.1%} are those of pvpython")
    if (difference < 3.0).mean() < 0.9:
        sys.exit("The view shows another picture than pvpython")
    if said:
        sys.exit("ParaView said that something is wrong")


if __name__ == "__main__":
    main()
