#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sectors and rings of a real fit (the paper's figure 4). The fit of every cone is done again here, step by step, and must give
the cones of the filter. Drawing needs a display."""

import by_hand
import common
import diagrams
import numpy as np
import scenes

NEIGHBORS, SECTORS, RING, FEWEST, THRESHOLD = 150, 12, 24, 25, 1.6  # p1 to p4, and the VarianceThreshold
STOP = (0.97, 0.80, 0.62)


def in_plane(fit, size):
    """The neighbours in the fitted plane, the rings, and the counts of the ring where it stops."""
    drawing, stop = diagrams.Drawing(), fit.rings
    inner, outer = fit.radii[stop - 1], fit.radii[stop]
    for sector, count in enumerate(fit.counts[stop]):
        first, last = (360.0 * (sector + part) / SECTORS - 180.0 for part in (0, 1))
        if count == 0:
            rims = [diagrams.circle((0, 0), radius, first, last, 25) for radius in (inner, outer)]
            strip = np.concatenate(rims)
            drawing.cells(strip, [(k, k + 1, k + 26, k + 25) for k in range(24)], "Polys", STOP)
        drawing.path([(0, 0), diagrams.circle((0, 0), fit.radii[-1], first, first, 1)[0]], diagrams.PALE, 1.0)
        drawing.say(str(count), 1.13 * outer * unit_at(0.5 * (first + last)) - (0.0, 0.05 * outer))
    for k, radius in enumerate(fit.radii[:stop + 1]):
        drawing.path(diagrams.circle((0, 0), radius), common.VERMILION if k == stop else common.TEAL, 1.5)
    drawing.path(diagrams.circle((0, 0), inner), common.RED, 3.0)
    dot = 0.016 * fit.radii[-1]
    for first, last, color in ((0, stop, common.GREEN), (stop, stop + 1, common.VERMILION)):
        drawing.dots(fit.places[first * RING:last * RING], color, dot)
    drawing.dots([(0, 0)], common.INK, 1.6 * dot)
    reach = 1.3 * outer
    return drawing.picture((-reach, -reach), (reach, reach), size)


def unit_at(degrees):
    return np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])


def on_plate(fit, vectors, plate, size):
    """The seed and its neighbours on the plate, from the lamp."""
    drawing = diagrams.Drawing(view=(0.0, -1.0, 0.0), up=(0.0, 0.0, -1.0))
    drawing.show(plate, common.GREY)
    points = diagrams.places(vectors)
    drawing.dots(points, (0.6, 0.6, 0.6), 0.007)
    drawing.dots(points[fit.near], common.GREEN, 0.012)
    drawing.dots(points[fit.near[:1]], common.INK, 0.025)
    return drawing.picture((-1.15, -1.15), (1.15, 1.15), size)


def bars(fit, size):
    """Variance over mean of each ring, and the threshold."""
    drawing, top, wide = diagrams.Drawing(), 1.1 * max(THRESHOLD, fit.dispersions.max()), 1.2 / len(fit.dispersions)
    for k, value in enumerate(fit.dispersions):
        color = common.TEAL if k < fit.rings else common.VERMILION if k == fit.rings else diagrams.PALE
        drawing.area(diagrams.rectangle((k + 0.15) * wide, (k + 0.85) * wide, 0.0, value / top), color)
        drawing.say(f"{value:.2f}", ((k + 0.5) * wide, 0.01), common.INK if k > fit.rings else (1.0, 1.0, 1.0))
        drawing.say(str(k + 1), ((k + 0.5) * wide, -0.08))
    drawing.path([(0.0, 0.0), (1.2, 0.0)], common.INK)
    drawing.dashes((0.0, THRESHOLD / top), (1.2, THRESHOLD / top), common.INK, dash=0.015)
    drawing.say("ring", (0.6, -0.16))
    drawing.say(f"threshold {THRESHOLD}", (0.2, THRESHOLD / top + 0.01))
    return drawing.picture((-0.05, -0.2), (1.25, 1.1), size)


def main():
    arguments = common.parse(common.parser(__doc__, size=520, vectors=3000))
    plate = scenes.label(scenes.l_plate())
    vectors = common.shadow_vectors(plate, scenes.ceiling_light(), arguments.vectors)
    cones = common.cone_set(vectors)
    cones.SetNumberOfNeighbors(NEIGHBORS)
    cones.SetNumberOfSectors(SECTORS)
    cones.SetPointsPerRing(RING)
    cones.SetMinimumVectorsPerCone(FEWEST)
    cones.SetVarianceThreshold(THRESHOLD)
    print(common.summary(cones), flush=True)
    fits = by_hand.fit_all(vectors.GetOutput(), NEIGHBORS, SECTORS, RING, FEWEST, THRESHOLD)
    by_hand.compare(fits, vectors.GetOutput(), cones.GetOutput())
    print(f"{len(fits)} fits done again: the same seeds, radii, axes and numbers of vectors")

    # One that stops after some rings at an edge, with many empty sectors; an early one, while nearly all vectors are there.
    shown = max(fits[:8], key=lambda fit: 2 <= fit.rings < len(fit.counts) and np.sum(fit.counts[fit.rings] == 0))
    size = arguments.size
    pictures = [on_plate(shown, vectors.GetOutput(), plate.GetOutputPort(), size), in_plane(shown, size), bars(shown, size)]
    titles = [f"a: {len(shown.near)} neighbours", f"b: {SECTORS} sectors, rings of {RING}", "c: variance over mean"]
    picture = common.table([pictures], titles)
    entries = ((common.GREEN, "vectors of the cone"), (common.VERMILION, "ring where it stops"), (STOP, "empty sectors of it"),
               (common.RED, "radius of the base"))
    common.save(common.stack(picture, common.key(entries, picture.shape[1])), f"{arguments.output}/figure4.png", levels=64)


if __name__ == "__main__":
    main()
