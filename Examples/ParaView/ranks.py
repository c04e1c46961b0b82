# SPDX-License-Identifier: BSD-3-Clause
"""Processes of ParaView that share the work: cones of a mesh, and what points on a floor see.

With one process, with two of a batch, and with two of a server that a client connects to:

    pvpython Examples/ParaView/ranks.py --plugin PLUGIN
    mpirun -np 2 pvbatch Examples/ParaView/ranks.py --plugin PLUGIN
    mpirun -np 2 pvserver --server-port=11111 &
    pvpython Examples/ParaView/ranks.py --plugin PLUGIN --server localhost:11111

where PLUGIN is <build folder>/lib/paraview-5.11/plugins/ShadowConesParaView/ShadowConesParaView.so. Without a display: xvfb-run -a before
each. All three print the same hashes.
"""

import argparse
import hashlib
import os

from paraview import servermanager, simple
from paraview.vtk.util.numpy_support import vtk_to_numpy

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Data")


def chain(mesh):
    """Every step from the mesh to answers."""
    occluders = simple.LabelOccluders(Input=simple.XMLPolyDataReader(FileName=[mesh]))
    light = simple.AreaLight(Shape="Disc", Center=[0.0, 5.49, 0.0], Normal=[0.0, -1.0, 0.0], Radius=0.5)
    vectors = simple.ShadowVectors(Input=occluders, Light=light)
    cones = simple.ConeSet(
        Input=simple.OutputPort(vectors, "Shadow Vectors"), PhotonPaths=simple.OutputPort(vectors, "Photon Paths"))
    floor = simple.Plane(Origin=[-2.75, 0.01, -2.75], Point1=[2.75, 0.01, -2.75], Point2=[-2.75, 0.01, 2.75],
                         XResolution=40, YResolution=40)
    seen = simple.ConeSetProbe(Input=floor, ConeSet=simple.OutputPort(cones, "Cone Set"), Light=light, Mesh=occluders)
    return cones, seen


def report(name, port, array):
    """Points, and a hash of one of their arrays: what all processes have, fetched to the client in the order of ranks."""
    data = servermanager.Fetch(port)
    values = vtk_to_numpy(data.GetPointData().GetArray(array))
    print(name, data.GetNumberOfPoints(), hashlib.sha256(values.tobytes()).hexdigest()[:16], flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plugin", help="ShadowConesParaView.so; not needed where ParaView loads it by itself")
    parser.add_argument("--server", help="host:port of a pvserver, which has to find the files under the same names")
    parser.add_argument("--mesh", default=os.path.join(DATA, "chair.vtp"), help="a .vtp file (default: the chair)")
    arguments = parser.parse_args()
    if arguments.server:
        host, port = arguments.server.split(":")
        simple.Connect(host, int(port))
    if arguments.plugin:
        plugin = os.path.abspath(arguments.plugin)
        if arguments.server:
            simple.LoadPlugin(plugin, remote=True, ns=simple.__dict__)
        simple.LoadPlugin(plugin, remote=False, ns=simple.__dict__)
    cones, seen = chain(os.path.abspath(arguments.mesh))
    print("processes", servermanager.ActiveConnection.GetNumberOfDataPartitions(), flush=True)
    report("cones", simple.OutputPort(cones, "Cone Set"), "BaseRadius")
    report("floor", seen, "Visibility")


if __name__ == "__main__":
    main()
