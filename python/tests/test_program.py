# SPDX-License-Identifier: GPL-3.0-or-later
"""The module and the program answer alike."""

import json
import os
import subprocess

import numpy as np
import pytest
from meshes import FOLDER, hourglass, read_off, write_off

import constrictions

PROGRAM = os.environ.get("CONSTRICTIONS_PROGRAM")
pytestmark = pytest.mark.skipif(PROGRAM is None, reason="CONSTRICTIONS_PROGRAM does not name the program")


def run(command, mesh, *options):
    arguments = [PROGRAM, command, FOLDER / mesh, "--json", "-", "--quiet", *options]
    return json.loads(subprocess.run(arguments, check=True, stdout=subprocess.PIPE).stdout)


def none_if_not_finite(values):
    return [None if not np.isfinite(x) else x for x in np.asarray(values).ravel()]


def check_same(curve, expected):
    # of a vertex any face may be given
    for i, location in enumerate(expected["locations"]):
        if i not in curve.pivot_points:
            assert (curve.faces[i], curve.barycentric[i].tolist()) == (location["face"], location["barycentric"])
    assert curve.points.tolist() == expected["points"]
    assert curve.pivots.tolist() == [p["vertex"] for p in expected["pivots"]]
    assert curve.pivot_points.tolist() == [p["point"] for p in expected["pivots"]]
    angles = [p[side] for p in expected["pivots"] for side in ("left_angle", "right_angle")]
    assert none_if_not_finite(curve.pivot_angles) == angles
    for name in "length", "roundness", "boundary_share":
        assert getattr(curve, name) == expected[name], name
    assert none_if_not_finite(curve.isoperimetric_ratio) == [expected["isoperimetric_ratio"]]
    for name in "areas", "genera", "centroid", "normal":
        assert getattr(curve, name).tolist() == expected[name], name
    for name in "side", "separating":
        assert getattr(curve, name) == expected[name], name


def check_same_constriction(curve, expected):
    check_same(curve, expected)
    for name in "prominence", "isolation":
        assert none_if_not_finite(getattr(curve, name)) == [expected[name]], name
    for name in "certificate", "dominated_by", "slides_off", "rim", "diameter":
        assert getattr(curve, name) == expected[name], name
    seed = {"level": curve.seed_level, "vertices": curve.seed.tolist(), "origin": curve.seed_origin}
    assert seed == expected["seed"]


@pytest.mark.parametrize("mesh", ["cactus.off", "elephant.off", "eight.off", "hand.off", "blobby.off"])
def test_curves_are_those_of_the_program(mesh):
    answer = run("detect", mesh)
    found = constrictions.Surface(*read_off(mesh)).detect()
    assert len(found) == len(answer["constrictions"])
    for curve, expected in zip(found, answer["constrictions"]):
        check_same_constriction(curve, expected)
    assert found.statistics == answer["statistics"]


def test_all_curves_are_those_of_the_program():
    answer = run("detect", "cactus.off", "--all", "--max-length", "0.5")
    found = constrictions.Surface(*read_off("cactus.off")).detect(all=True, max_length=0.5)
    assert len(found) == len(answer["constrictions"]) > 3
    for curve, expected in zip(found, answer["constrictions"]):
        check_same_constriction(curve, expected)


def test_curves_of_a_mesh_with_holes_are_those_of_the_program(tmp_path):
    V, F = hourglass(closed=False)
    write_off(tmp_path / "open.off", V, F)
    answer = run("detect", tmp_path / "open.off", "--rims")
    found = constrictions.Surface(V, F).detect(rims=True)
    assert len(found) == len(answer["constrictions"]) == 3
    for curve, expected in zip(found, answer["constrictions"]):
        check_same_constriction(curve, expected)


def test_curves_near_a_place_are_those_of_the_program():
    place = [0.28, 0.1, 0.1]
    answer = run("detect", "cactus.off", "--near", ",".join(map(str, place)))
    found = constrictions.Surface(*read_off("cactus.off")).near(place)
    assert len(found) == len(answer["constrictions"]) > 0
    for curve, expected in zip(found, answer["constrictions"]):
        check_same_constriction(curve, expected)


def test_girths_are_those_of_the_program():
    place = [0.28, 0.1, 0.1]
    answer = run("girth", "cactus.off", "--at", ",".join(map(str, place)), "--max", "4", "--min-angle", "0.8")
    loops = constrictions.Surface(*read_off("cactus.off")).girth(place, max_number=4, min_angle=0.8)
    assert len(loops) == len(answer["constrictions"]) > 0
    for loop, expected in zip(loops, answer["constrictions"]):
        check_same(loop, expected)
        held = expected["held"]
        assert none_if_not_finite([loop.left_angle, loop.right_angle]) == [held["left_angle"], held["right_angle"]]
        assert (loop.closed_geodesic, loop.let_go) == (held["closed_geodesic"], held["let_go"])
        assert (loop.constriction.length if loop.constriction else None) == held["let_go_length"]


def test_sections_are_those_of_the_program():
    place, axis = [0.28, 0.1, 0.1], [0.3, -1, 0.2]
    answer = run("girth", "cactus.off", "--at", ",".join(map(str, place)), "--axis=" + ",".join(map(str, axis)))
    section = constrictions.Surface(*read_off("cactus.off")).section(place, axis)
    (expected,) = answer["sections"]
    assert (section.kind, section.length, section.curves) == (expected["kind"], expected["length"], expected["curves"])
    assert section.points.tolist() == expected["points"]
    assert (section.loop is None) == (expected["constriction"] is None)
    if section.loop:
        check_same(section.loop, answer["constrictions"][expected["constriction"]])


def test_the_program_certifies_what_the_module_finds(tmp_path):
    surface = constrictions.Surface(*read_off("elephant.off"))
    curves = [
        {
            "locations": [{"face": f, "barycentric": b} for f, b in zip(c.faces.tolist(), c.barycentric.tolist())],
            "pivots": [{"vertex": v, "point": p} for v, p in zip(c.pivots.tolist(), c.pivot_points.tolist())],
        }
        for c in surface.detect()
    ]
    file = tmp_path / "curves.json"
    file.write_text(json.dumps({"format": "constrictions/1", "constrictions": curves}))
    subprocess.run([PROGRAM, "certify", FOLDER / "elephant.off", "--curves", file, "--quiet"], check=True)
