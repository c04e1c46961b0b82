#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the command says of input that is wrong, and what Ctrl-C leaves."""

import os
import shutil
import signal
import subprocess
import time
import unittest

from program import PROGRAM, ProgramTest, box

LAMP = ["--light", "disc:0,0,9", "radius", 1, "facing", "0,0,-1"]


class FaultTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("cube.obj", box((-1, -1, 2), (1, 1, 4)))
        self.write("empty.obj", "# nothing\n")
        self.write("garbage.stl", "\x01\x02 this is no mesh")
        self.write("bad.csv", "x,y,z\n1,2,3\n1,2,low\n")
        self.write("headless.csv", "1,2,3\n")
        self.files = sorted(os.listdir(self.folder))

    def test_table(self):
        """Each line: words, exit code, what the message has to say."""
        table = [
            ([], 2, "subcommand is required"),
            (["image"], 2, "MESH"),
            (["picture", "cube.obj"], 2, "picture"),
            (["image", "cube.obj"], 2, "--output"),
            (["image", "none.obj", "-o", "a.png"], 1, "none.obj"),
            (["image", "empty.obj", "-o", "a.png"], 1, "empty.obj"),
            (["image", "garbage.stl", "-o", "a.png"], 1, "garbage.stl"),
            (["image", "cube.obj", "-o", "a.gif"], 2, "png, tif, vti"),
            (["image", "cube.obj", "-o", "nowhere/a.png"], 1, "No such file or directory"),
            (["image", "cube.obj", "-o", "a.png", "--size", "0x9"], 2, "640x480"),
            (["image", "cube.obj", "-o", "a.png", "--error", "-1"], 1, "RelativeErrorGoal"),
            (["probe", "cube.obj", "--light", "disk:0,0,9", "--at", "0,0,0"], 2, "disc, rectangle"),
            (["probe", "cube.obj", "--light", "disc:0,0,9", "radius", "x", "--at", "0,0,0"], 2, "column"),
            (["probe", "cube.obj", *LAMP, "--at", "0,0"], 2, "3 numbers"),
            (["probe", "cube.obj", *LAMP, "--at", "0,0,0", "--grid", "2,2,2"], 2, "--grid"),
            (["probe", "cube.obj", *LAMP, "--grid", "2,2,2", "-o", "a.vtp"], 2, "vti"),
            (["probe", "cube.obj", *LAMP, "--where", "none.csv"], 2, "none.csv"),
            (["probe", "cube.obj", *LAMP, "--where", "bad.csv"], 1, "line 3: expected a number in column z, found 'low'"),
            (["probe", "cube.obj", *LAMP, "--where", "headless.csv"], 1, "columns named x, y and z"),
            (["irradiance", "cube.obj", *LAMP, "--at", "0,0,0"], 2, "--facing"),
            (["probe", "cube.obj", *LAMP, "--unit", "mile", "--at", "0,0,0"], 2, "mm, cm, m"),
            (["solids", "cube.obj", *LAMP, "--method", "projection", "-o", "a.stl"], 1, "vtkShadowVolume"),
            (["sun-hours", "cube.obj", "--latitude", 95, "--longitude", 0, "--start", "2026-01-01", "--end", "2026-01-02", "--at", "0,0,0"],
             1, "Latitude"),
            (["page", "cube.obj", "-o", "a.htm"], 2, ".html"),
        ]
        for words, wanted, message in table:
            with self.subTest(words=words):
                code, out, error = self.run_program(*words)
                self.assertEqual(code, wanted, out + error)
                self.assertIn(message, error)
                self.assertEqual(sorted(os.listdir(self.folder)), self.files)

    def test_full_disk(self):
        """Standard output that takes nothing is an error."""
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run(self.command("probe", "cube.obj", *LAMP, "--at", "0,0,0", "-q"), cwd=self.folder, stdout=full,
                                  stderr=subprocess.PIPE, text=True, timeout=100)
        self.assertEqual(done.returncode, 1)
        self.assertIn("standard output", done.stderr)

    def test_no_display(self):
        environment = {name: value for name, value in os.environ.items() if name != "DISPLAY"}
        done = subprocess.run(self.command("image", "cube.obj", *LAMP, "--size", "8x8", "-o", "a.png", "-q"), cwd=self.folder,
                              env=environment, timeout=100)
        self.assertEqual(done.returncode, 0)

    @staticmethod
    def wait_for_handler(running):
        """Until the process has a handler for SIGINT: before, it is not the program yet that Ctrl-C ends."""
        for _ in range(600):
            with open(f"/proc/{running.pid}/status", encoding="ascii") as status:
                caught = next(line for line in status if line.startswith("SigCgt:"))
            if int(caught.split()[1], 16) >> (signal.SIGINT - 1) & 1 or running.poll() is not None:
                return
            time.sleep(0.1)

    def test_interrupt(self):
        """Ctrl-C at three moments: code 130 within five seconds, and the old file as it was."""
        for wait in (0.0, 0.5, 1.5):
            self.write("a.png", "old")
            running = subprocess.Popen(
                self.command("image", "cube.obj", *LAMP, "--size", "1600x1600", "--error", 1e-4, "-o", "a.png", "-q"),
                cwd=self.folder, stderr=subprocess.PIPE, text=True)
            self.wait_for_handler(running)
            time.sleep(wait)
            running.send_signal(signal.SIGINT)
            start = time.monotonic()
            _, error = running.communicate(timeout=60)
            self.assertEqual(running.returncode, 130, error)
            self.assertIn("interrupted", error)
            self.assertLess(time.monotonic() - start, 5.0)
            with open(self.path("a.png"), encoding="utf-8") as file:
                self.assertEqual(file.read(), "old")
            self.assertEqual(sorted(os.listdir(self.folder)), sorted([*self.files, "a.png"]))

    def test_progress(self):
        """Without a terminal: lines, no bar."""
        _, _, error = self.run_program("probe", "cube.obj", *LAMP, "--at", "0,0,0")
        self.assertIn("asking: ", error)
        self.assertNotIn("\r", error)

    def test_help(self):
        """Every command has a help text with three examples, and every example names options that there are."""
        code, out, _ = self.run_program("--help")
        self.assertEqual(code, 0)
        commands = [line.split()[0] for line in out.split("Subcommands:")[1].split("Examples:")[0].strip().split("\n")]
        self.assertEqual(sorted(commands), sorted(
            "image vectors cones probe irradiance fluence shadow-of widths footprints solids sun-hours accuracy page bench".split()))
        for command in commands:
            code, text, _ = self.run_program(command, "--help")
            self.assertEqual(code, 0)
            self.assertEqual(text.count(f"  shadowcones {command} "), 3, command)
            for line in text.split("Examples:")[1].strip().split("\n"):
                for option in [word.split("=")[0] for word in line.split() if word.startswith("--")]:
                    self.assertIn(option + (" " if option != "--help" else ""), text.split("Examples:")[0] + " ", line)

    def test_version(self):
        code, out, _ = self.run_program("--version")
        self.assertEqual(code, 0)
        self.assertRegex(out, r"^shadowcones \d+\.\d+\.\d+\n$")

    def test_manual(self):
        """man reads the manual without a complaint, and the shell the completion."""
        code, page, _ = self.run_program("--manual")
        self.assertEqual(code, 0)
        self.assertTrue(page.startswith(".TH SHADOWCONES 1"))
        if shutil.which("groff"):
            done = subprocess.run(["groff", "-man", "-Tascii", "-ww"], input=page, capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("sun-hours", done.stdout)
        code, script, _ = self.run_program("--completion")
        self.assertEqual(code, 0)
        words = 'COMP_WORDS=(shadowcones probe --li); COMP_CWORD=2; _shadowcones; echo "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "-c", script + words], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.stdout.strip(), "--light", done.stderr)


if __name__ == "__main__":
    assert os.path.exists(PROGRAM), PROGRAM
    unittest.main(verbosity=2)
