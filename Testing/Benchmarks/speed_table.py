#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The figures of speed that are wanted, all from one run: what is wanted, what was measured, and whether it is met.

    xvfb-run -a /usr/bin/python3 Testing/Benchmarks/speed_table.py                    # half an hour on two idle cores
    xvfb-run -a /usr/bin/python3 Testing/Benchmarks/speed_table.py --rows probe umbra

Run it from where the project was built (build/). Every row calls one of the benchmark programs; what they print goes to --log. Seconds
are by the wall clock on two threads, so that another job on the machine spoils them; ratios are of processor time where both sides can be.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
BUNNY = "/usr/share/glmark2/models/bunny.obj"  # of the package glmark2-data
ROWS = {}


def row(measure):
    """A function that takes a Bench and yields lines: what, wanted, measured, met."""
    ROWS[measure.__name__] = measure
    return measure


class Bench:
    """Runs the programs of a build, and keeps what they print."""

    def __init__(self, build, log):
        self.build = os.path.abspath(build)
        self.log = log

    def __call__(self, *command):
        self.log.write("$ " + " ".join(command) + "\n")
        self.log.flush()
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=self.log, text=True, check=True)
        self.log.write(done.stdout)
        self.log.flush()
        return done.stdout

    def pipeline(self, *options):
        return self(os.path.join(self.build, "bin", "pipeline-speed"), *options)

    def script(self, name, *options):
        return self(sys.executable, os.path.join(HERE, name), *options)

    def scattering(self, scene, *options):
        """Comparisons at equal error by the wall clock: error, seconds and ratio under their names, in order."""
        with tempfile.TemporaryDirectory() as folder:
            figures = os.path.join(folder, "figures.json")
            self(os.path.join(self.build, "bin", "scattering-speed"), "--scene", scene, "--repeats", "3", "--json", figures,
                 "--cache", folder, *options)
            with open(figures, encoding="utf-8") as file:
                return json.load(file)[0]["at_equal_error"]


def figures(pattern, text):
    """What the groups of a pattern hold, as numbers, at every place where it is found; at least at one."""
    found = [tuple(float(value) for value in match) for match in (found.groups() for found in re.finditer(pattern, text))]
    if not found:
        raise ValueError(f"'{pattern}' is not in what was printed:\n{text}")
    return found


def below(what, limit, value, unit="s"):
    return what, f"at most {limit:g} {unit}", f"{value:.3g} {unit}", value <= limit


def above(what, limit, value, unit="x", bound=""):
    return what, f"at least {limit:g} {unit}", f"{bound}{value:.3g} {unit}", value >= limit


def bodies():
    return ["chair", "tree"] + ([BUNNY] if os.path.exists(BUNNY) else [])


def named(scene):
    return os.path.splitext(os.path.basename(scene))[0]


@row
def first(bench):
    """The default call makes no cones: it is held against Guided without cones, and so are the default cones."""
    for scene in bodies():
        text = bench.pipeline("--rows", "first", "--size", "128", "--scene", scene)
        (default,), (cones,) = (figures(way + r": processor \S+ s, (\S+) times", text)[0]
                                for way in ("vtkLightShafts", "with cones as by default"))
        yield (f"first image, {named(scene)}: default call; with cones", "1 x; else left out", f"{default:.2f}; {cones:.2f} x",
               default >= 0.95)


@row
def dark(bench):
    """127 x 127 pixels are 160 x 100, 83 x 83 are 96 x 72, and 506 x 506 are 640 x 400."""
    with tempfile.TemporaryDirectory() as folder:
        text = bench.pipeline("--rows", "dark", "--cache", folder)
    for scene, error, limit in (("blinds", 2.5, 0.5), ("blinds", 1, 2.0), ("canopy", 1.5, 0.4), ("canopy", 0.7, 1.0)):
        (seconds, bound), = re.findall(rf"{scene}, .* Guided errs by {error:g} % after (\S+) s(.*)", text)
        (march, march_error), = figures(rf"{scene}, .* light points: (\S+) s, error (\S+) %", text)
        yield (f"{scene}, Guided at an error of {error:g} %", f"at most {limit:g} s",
               f"{seconds} s{bound}; the march errs by {march_error:g} % after {march:.2g} s",
               not bound.startswith(":") and float(seconds) <= limit)
    (seconds,), = figures(r"goal \.02: (\S+) s", text)
    yield below("blinds, as many pixels as 640 x 400, goal .02", 5.0, seconds)


@row
def fog(bench):
    text = bench.pipeline("--rows", "fog")
    for mode, kind, limit in (("Guided", "the same everywhere", 3), ("Guided", r"smooth, 32\^3", 3), ("Guided", r"wispy, 32\^3", 3),
                              ("Guided", r"smooth, 64\^3", 10), ("Guided", r"wispy, 64\^3", 10), ("BruteForce", r"smooth, 64\^3", 3),
                              ("BruteForce", r"wispy, 64\^3", 3)):
        ratios = [value for value, in figures(mode + r", 64 x 64, " + kind + r": .* ratio ([\d.]+)", text)]
        yield (f"{mode} with a density over without, {kind.replace(chr(92), '')}: chair, slats", f"at most {limit} x",
               ", ".join(f"{value:.3g}" for value in ratios) + " x", max(ratios) <= limit)


@row
def frames(bench):
    (further, exposed, rays), = figures(r"further ones (\S+) s .*exposure (\S+) s and (\d+) rays", bench.pipeline("--rows", "frames"))
    yield below("further frame, 10^6 triangles, Volume, 256 x 256", 0.1, further)
    yield "another exposure", "no ray", f"{rays:.0f} rays, {exposed:.2g} s", rays == 0


@row
def pixels(bench):
    text = bench.pipeline("--rows", "pixels", "--size", "512", "--largest", "2048", "--judged", "40")
    found = figures(r"Guided, (\d+) x \d+: (\S+) s, processor (\S+) s, (\S+) rays", text)
    yield below("sphere of 10^6 triangles, goal .01, 2048 x 2048", 12.0, found[-1][1])
    exponent = figures(r"to the power of ([\d.]+)", text)[0][0]
    yield ("growth with pixels, 512 to 2048", "at most .8", f"{exponent:.2f}; rays a pixel " +
           ", ".join(f"{rays:.0f}" for *_, rays in found), exponent <= 0.8)
    claims = figures(r"error \S+ %, (\S+) of the claims, (\S+) % within two", text)
    yield ("its claims, 40 pixels of each", "within two of them, 95 %", ", ".join(f"{within:.0f} %" for _, within in claims),
           min(within for _, within in claims) >= 95.0)


@row
def probe(bench):
    (seconds,), = figures(r"again (\S+) s", bench.pipeline("--rows", "probe", "--scene", "tree"))
    yield below("probe, tree, 20,000 points x 64", 0.3, seconds)


@row
def volume(bench):
    (prepared, further), = figures(r"first image (\S+) s, further ones (\S+) s", bench.pipeline("--rows", "volume"))
    yield ("visibility volume of 257^3 points read by frames", "prepared once", f"{prepared:.3g} s, then {further:.3g} s a frame",
           further < 0.5 * prepared)


@row
def surfaces(bench):
    """Today's noisy frame has 16 samples a point whatever the goal."""
    for scene in bodies():
        text = bench.script("surface_noise.py", scene)
        for goal, limit in (("0.05", 1.5), ("0.01", 4.0)):
            (frame, own, fixed, error), = figures(
                rf"goal {goal}: frame (\S+) s, surfaces (\S+) s with .* rays, (\S+) s with 16 a point; error ([\d.]+)%", text)
            ratio = frame / (frame - own + fixed)
            yield (f"surfaces, {named(scene)}, goal {goal}, over 16 samples a point", f"at most {limit:g} x",
                   f"{ratio:.2f} x; error {error:.2g} %", ratio <= limit)


@row
def threads(bench):
    stages = (("Guided", "768"), ("Volume", "1024"), ("BruteForce", "256"), ("fill", "256"), ("cones", "256"), ("tuning", "256"))
    for stage, size in stages:
        text = bench.pipeline("--rows", "threads", "--size", size, "--stages", stage)
        (faster, two, sixteen, many), = figures(
            rf"  {stage} +\S+ +\S+ +(\S+) +\S+ % +(\S+) x \| +(\S+) % +\S+ x \| +(\S+) % ", text)
        yield (f"two threads against one, {stage}, chair, {size} x {size}", "at least 1.85 x",
               f"{faster:.2f} x; replayed {two:.2f} x", faster >= 1.85)
        yield f"16; 64 threads, replayed, {stage}", "90 % busy", f"{sixteen:.0f}; {many:.0f} %", min(sixteen, many) >= 90.0


@row
def umbra(bench):
    for resolution, exponent in figures(r"resolution (\d+): time grows .* power of ([\d.]+)", bench.pipeline("--rows", "umbra")):
        yield (f"umbra field, resolution {resolution:.0f}: growth with discs", "about 1", f"{exponent:.2f}", exponent <= 1.2)


@row
def further(bench):
    """At an error of .7 %, on the tree of 1.4 %."""
    for scene in bodies():
        compared = bench.scattering(scene)
        name, limit = ("Guided, cones given, against (c)", 2.0) if scene == "tree" else (
            "further images, against (c)", 5.0 if scene == "chair" else 4.0)
        known = [each for each in compared if each["name"] == name and "ratio" in each]
        if scene != "tree":
            known = [each for each in known if "at_least" in each]
        for each in known[:1]:
            open_side = ">= " if each["time"]["is"] == "at most" else ""
            yield above(f"{name}, {named(scene)}, error {100 * each['error']:.2g} %", limit, each["ratio"], bound=open_side)


@row
def growth(bench):
    """Exponents of all stages; the first of its parameters that an image has."""
    text = bench(os.path.join(bench.build, "bin", "scattering-speed"), "--scene", "chair", "--sweep", "--repeats", "3", "--cache", tempfile.gettempdir())
    parameter = ""
    for line in text.splitlines():
        heading = re.match(r"  (\S.*?)  +[\d.e+]+ .*exponent$", line)
        stage = re.match(r"    (\S+) .* (-?[\d.]+)$", line)
        if heading:
            parameter = heading[1]
        elif stage and stage[1] in ("vectors", "cones", "fill", "Guided", "Volume", "BruteForce"):
            yield f"{stage[1]} grows with {parameter} to the power of", "known", stage[2], True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", nargs="+", choices=list(ROWS), default=list(ROWS), metavar="ROW", help=", ".join(ROWS))
    parser.add_argument("--build", default="build", help="folder of the build (%(default)s)")
    parser.add_argument("--log", default="speed_table.log", help="what the programs print (%(default)s)")
    arguments = parser.parse_args()
    missed = 0
    print("| what | wanted | measured | |\n|---|---|---|---|")
    with open(arguments.log, "w", encoding="utf-8") as log:
        for name in arguments.rows:
            for what, wanted, measured, met in ROWS[name](Bench(arguments.build, log)):
                missed += not met
                print(f"| {what} | {wanted} | {measured} | {'met' if met else 'not met'} |", flush=True)
    print(f"\nnot met: {missed}")


if __name__ == "__main__":
    main()
