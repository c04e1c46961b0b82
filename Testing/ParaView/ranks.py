#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""One process of ParaView, two of a batch and two of a server with a client: the same answers.

    python3 Testing/ParaView/ranks.py PREFIX PLUGIN

PREFIX is where ParaView lies (PREFIX/usr/bin/pvpython), PLUGIN the file ShadowConesParaView.so.
"""

import argparse
import os
import re
import shutil
import socket
import subprocess
import sys
import time

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "ParaView", "ranks.py")
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
SECONDS = 120


def answers(command, processes):
    """What a run of the script says behind its number of processes."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False, env=ENVIRONMENT)
    found = re.findall(r"^(processes|cones|floor) (.*)$", done.stdout, re.M)
    if done.returncode or [name for name, _ in found] != ["processes", "cones", "floor"] or "ERR|" in done.stderr:
        sys.exit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
    print(" ".join(f"{name} {value}" for name, value in found), flush=True)
    if found[0][1] != str(processes):
        sys.exit(f"{' '.join(command)} ran in {found[0][1]} processes, not {processes}")
    return found[1:]


def free_port():
    with socket.socket() as probe:
        probe.bind(("localhost", 0))
        return probe.getsockname()[1]


def of_server(display, parallel, binaries, script):
    """A server of two processes and a client."""
    port = free_port()
    command = [*display, *parallel, os.path.join(binaries, "pvserver"), f"--server-port={port}"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=ENVIRONMENT) as server:
        try:
            for line in server.stdout:
                if "Accepting connection" in line:
                    break
            else:
                sys.exit(f"{' '.join(command)} did not start")
            time.sleep(0.5)
            return answers([*display, os.path.join(binaries, "pvpython"), *script, "--server", f"localhost:{port}"], 2)
        finally:
            server.terminate()
            server.wait(20)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("prefix")
    parser.add_argument("plugin")
    arguments = parser.parse_args()
    mpirun = shutil.which("mpirun")
    if not mpirun:
        print("Skipped: there is no mpirun")
        sys.exit(77)
    display = ["xvfb-run", "-a"] if shutil.which("xvfb-run") else []
    binaries = os.path.join(arguments.prefix, "usr", "bin")
    script = [SCRIPT, "--plugin", arguments.plugin]
    parallel = [mpirun, "--oversubscribe", "-np", "2"]
    alone = answers([*display, os.path.join(binaries, "pvpython"), *script], 1)
    batch = answers([*display, *parallel, os.path.join(binaries, "pvbatch"), *script], 2)
    server = of_server(display, parallel, binaries, script)
    if not alone == batch == server:
        sys.exit("they differ")


main()
