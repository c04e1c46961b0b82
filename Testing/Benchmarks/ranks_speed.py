#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Several processes of MPI on one scene: seconds, shares and messages of each step, and a model of more of them.

    xvfb-run -a python3 Testing/Benchmarks/ranks_speed.py --ranks 1 2 3 4 --picture ranks.png

Each process has one thread. Seconds are processor seconds, without those in exchanges, of the process that took most: what each would
take with a core of its own. Exchanges are added by the model of a step:
t(R) = alone + shared / R + meetings (latency ceil(log2 R)) + bytes (1 - 1/R) / bandwidth, with all of it measured here.
"""

import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import time

STEPS = ("photons", "cones", "fill", "image")


def worker(options):
    """One process: the chain, once, with the time of each filter."""
    from mpi4py import MPI  # before VTK's, which uses what this has begun
    from vtkmodules.vtkParallelMPI import vtkMPIController
    from vtkmodules.vtkParallelCore import vtkMultiProcessController

    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
    import scenes
    import shadowcones as sc

    comm = MPI.COMM_WORLD
    controller = vtkMPIController()
    controller.Initialize()
    vtkMultiProcessController.SetGlobalController(controller)
    occluders = sc.vtkLabelOccluders()
    occluders.SetInputData(scenes.read(os.path.join(scenes.DATA, options.mesh + ".vtp")))
    light = scenes.ceiling_light()
    vectors = sc.vtkShadowVectorFilter()
    vectors.SetInputConnection(occluders.GetOutputPort())
    vectors.SetLightConnection(light.GetOutputPort())
    vectors.SetNumberOfPhotons(options.photons)
    cones = sc.vtkConeSetFilter()
    cones.SetInputConnection(vectors.GetOutputPort())
    cones.SetTuningToManual()
    volume = sc.vtkVisibilityVolume()
    volume.SetMeshConnection(occluders.GetOutputPort())
    volume.SetInputConnection(cones.GetOutputPort())
    volume.SetLightConnection(light.GetOutputPort())
    volume.SetDimensions(options.points, options.points, options.points)
    volume.SetBounds(*scenes.MEDIUM_BOUNDS)
    volume.SetNumberOfLightSamples(64)
    image = sc.vtkScatteringImageFilter()
    image.SetInputConnection(occluders.GetOutputPort())
    image.SetLightConnection(light.GetOutputPort())
    image.SetVisibilityVolumeConnection(volume.GetOutputPort())
    image.SetCamera(scenes.front_camera())
    image.SetResolution(options.size, options.size)
    image.SetMediumBounds(*scenes.MEDIUM_BOUNDS)
    image.SetModeToBruteForce()
    image.SetNumberOfLightSamples(2)
    image.AutoExposureOff()

    figures = {}
    names = {vectors: "photons", cones: "cones", volume: "fill", image: "image"}
    work = sc.vtkRankWork

    def state():
        return [time.process_time() - work.GetProcessorSeconds(), work.GetNumberOfItems(), work.GetNumberOfRays(),
                work.GetNumberOfMeetings(), work.GetBytesSent()]

    def begin(one, _):
        figures[names[one]] = state()

    def end(one, _):
        figures[names[one]] = [b - a for a, b in zip(figures[names[one]], state())]

    for one in names:
        one.AddObserver("StartEvent", begin)
        one.AddObserver("EndEvent", end)
    comm.Barrier()
    image.UpdatePiece(comm.Get_rank(), comm.Get_size(), 0)

    def seconds_of(length, times):
        own = bytearray(length)
        everybody = bytearray(length * comm.Get_size())
        comm.Barrier()
        start = time.perf_counter()
        for _ in range(times):
            comm.Allgather(own, everybody)
        return (time.perf_counter() - start) / times

    link = {"latency": seconds_of(8, 200), "seconds_4MB": seconds_of(1 << 22, 5)}
    everything = comm.gather(figures)
    if comm.Get_rank() == 0:
        print("FIGURES " + json.dumps({"processes": everything, "link": link}), flush=True)
    vtkMultiProcessController.SetGlobalController(None)


def measure(options, ranks):
    """The least processor seconds of each step of some runs, of the process that took most; with shares and messages."""
    command = [shutil.which("mpirun") or "mpirun", "--oversubscribe", "-np", str(ranks), sys.executable, os.path.abspath(__file__),
               "--worker", "--mesh", options.mesh, "--photons", str(options.photons), "--points", str(options.points),
               "--size", str(options.size)]
    environment = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
                   "VTK_SMP_BACKEND_IN_USE": "Sequential"}
    best = {}
    link = {}
    for _ in range(options.repeats):
        done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
        lines = [line for line in done.stdout.splitlines() if line.startswith("FIGURES ")]
        if done.returncode or not lines:
            sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
        found = json.loads(lines[0][len("FIGURES "):])
        link = found["link"]
        for step in STEPS:
            columns = list(zip(*(process[step] for process in found["processes"])))
            one = {"seconds": max(columns[0]), "items": columns[1], "rays": columns[2], "meetings": columns[3][0],
                   "bytes": sum(columns[4])}
            if step not in best or one["seconds"] < best[step]["seconds"]:
                best[step] = one
    return best, link


def model(step, single, link, ranks):
    """Seconds of a step with so many processes. What is alone in a step is what the measured pair does not share."""
    if ranks == 1:
        return single[step]["alone"] + single[step]["shared"]
    messages = single[step]["meetings"] * link["latency"] * math.ceil(math.log2(ranks))
    return (single[step]["alone"] + single[step]["shared"] / ranks + messages
            + single[step]["bytes"] * (1.0 - 1.0 / ranks) / link["bandwidth"])


def draw(path, single, link):
    """Speed-up of each step over processes, both axes logarithmic."""
    from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartLegend, vtkChartXY
    from vtkmodules.vtkCommonCore import vtkFloatArray
    from vtkmodules.vtkCommonDataModel import vtkTable
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
    from vtkmodules.vtkViewsContext2D import vtkContextView
    import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401

    counts = [2 ** k for k in range(11)]
    table = vtkTable()
    columns = [("processes", counts), ("as many", counts)]
    columns += [(step, [model(step, single, link, 1) / model(step, single, link, n) for n in counts]) for step in STEPS]
    for name, values in columns:
        array = vtkFloatArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        table.AddColumn(array)
    view = vtkContextView()
    view.GetRenderWindow().SetOffScreenRendering(1)
    view.GetRenderWindow().SetSize(900, 600)
    view.GetRenderer().SetBackground(1, 1, 1)
    chart = vtkChartXY()
    view.GetScene().AddItem(chart)
    colors = ((160, 160, 160), (220, 120, 0), (0, 120, 60), (30, 90, 220), (180, 30, 90))
    for k, color in enumerate(colors):
        line = chart.AddPlot(vtkChart.LINE)
        line.SetInputData(table, 0, k + 1)
        line.SetColor(*color, 255)
        line.SetWidth(3.0 if k else 1.5)
    for position, title in ((vtkAxis.BOTTOM, "processes"), (vtkAxis.LEFT, "times as fast as one")):
        axis = chart.GetAxis(position)
        axis.SetTitle(title)
        axis.LogScaleOn()
    chart.SetShowLegend(True)
    chart.GetLegend().SetHorizontalAlignment(vtkChartLegend.LEFT)
    view.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.GetRenderWindow())
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2], help="numbers of processes, 1 first (default: 1 2)")
    parser.add_argument("--mesh", default="tree", help="a mesh of Data/ (default: tree)")
    parser.add_argument("--photons", type=int, default=400000)
    parser.add_argument("--points", type=int, default=49, help="of the grid along each side (default: 49)")
    parser.add_argument("--size", type=int, default=128, help="pixels along each side (default: 128)")
    parser.add_argument("--repeats", type=int, default=2)
    parser.add_argument("--picture", help="a .png of the model up to 1024 processes")
    parser.add_argument("--worker", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.worker:
        worker(options)
        return
    found = {ranks: measure(options, ranks) for ranks in options.ranks}
    one = found[1][0]
    print("| processes | step | s | times as fast | with exchanges, model | largest share | meetings | bytes of all |\n"
          "|---|---|---|---|---|---|---|---|")
    single = {}
    link = {"latency": 0.0, "bandwidth": 1e9}
    if 2 in found:
        two, seconds = found[2]
        link = {"latency": seconds["latency"], "bandwidth": (1 << 22) / max(seconds["seconds_4MB"], 1e-9)}
        for step in STEPS:
            # Of two processes: t2 = alone + shared / 2, where t1 = alone + shared.
            shared = min(max(2.0 * (one[step]["seconds"] - two[step]["seconds"]), 0.0), one[step]["seconds"])
            single[step] = {"shared": shared, "alone": one[step]["seconds"] - shared, "meetings": two[step]["meetings"],
                            "bytes": two[step]["bytes"]}
    for ranks, (figures, _) in found.items():
        for step in STEPS:
            of = figures[step]
            counted = of["items"] if sum(of["items"]) else of["rays"]
            largest = max(counted) / sum(counted) if sum(counted) else 1.0 / ranks
            expected = f"{model(step, single, link, 1) / model(step, single, link, ranks):.2f}" if single else ""
            print(f"| {ranks} | {step} | {of['seconds']:.3f} | {one[step]['seconds'] / of['seconds']:.2f} | {expected} | {largest:.3f} | "
                  f"{of['meetings']} | {of['bytes']} |")
    print(f"latency {1e6 * link['latency']:.1f} us, bandwidth {link['bandwidth'] / 1e6:.0f} MB/s")
    if options.picture and single:
        draw(options.picture, single, link)


if __name__ == "__main__":
    main()
