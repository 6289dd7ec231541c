#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the set of bodies with known narrow places, in benchmark/Surface_mesh_constrictions/thousand_necks."""
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "benchmark", "Surface_mesh_constrictions",
                      "thousand_necks")
sys.path.insert(0, FOLDER)

import bodies  # noqa: E402
import plane_sections  # noqa: E402
import run  # noqa: E402
import score  # noqa: E402
import surfaces  # noqa: E402

# Of each family the first bodies, fewer of those that take long.
SOME = {**bodies.QUICK, "trees": 1, "pores": 1}
_made = {}


def some_bodies():
    for family in bodies.FAMILIES:
        for number in range(SOME.get(family, 3)):
            if (family, number) not in _made:
                _made[family, number] = bodies.body(family, number)
            yield _made[family, number]


class Bodies(unittest.TestCase):
    def test_are_oriented_manifolds_of_the_stated_topology(self):
        for body in some_bodies():
            with self.subTest(body.name):
                self.assertEqual(surfaces.topology(body.mesh), body.topology)

    def test_face_outwards(self):
        for body in some_bodies():
            with self.subTest(body.name):
                if body.topology.holes == 0:
                    self.assertGreater(surfaces.signed_volume(body.mesh), 0)

    def test_known_loops_are_on_the_mesh_and_around_the_axis(self):
        for body in some_bodies():
            with self.subTest(body.name):
                of_vertex = {}
                for face, corners in enumerate(body.mesh.faces.tolist()):
                    for v in corners:
                        of_vertex.setdefault(v, set()).add(face)
                for place in body.places:
                    for loop in place.loops:
                        for (u, v, t), (x, y, s) in zip(loop, loop[1:] + loop[:1]):
                            self.assertTrue(0 <= t <= 1 and 0 <= s <= 1)
                            self.assertTrue(of_vertex[u] & of_vertex[v] & of_vertex[x] & of_vertex[y])
                        points = surfaces.positions(body.mesh, loop)
                        self.assertTrue(score.encircles(points, place))
                        self.assertTrue(score.is_on_surface(body.mesh, points))

    def test_are_wider_at_the_ends_of_the_axis(self):
        for body in some_bodies():
            with self.subTest(body.name):
                for place in body.places:
                    direction = place.axis[1] - place.axis[0]
                    direction /= math.sqrt((direction * direction).sum())
                    for end in place.axis:
                        loops = surfaces.sections(body.mesh, end, direction)
                        curves = [surfaces.positions(body.mesh, loop) for loop in loops]
                        around = [surfaces.length(c) for c in curves if abs(bodies.winding(c, end, direction)) == 1]
                        least = bodies.known_length(body.mesh, place) * (1.03 if "shallow" in body.family else 1.15)
                        self.assertTrue(all(other > least for other in around), around)

    def test_known_lengths_are_those_of_the_construction(self):
        first = bodies.body("boxes with a tube", 0)
        self.assertAlmostEqual(bodies.known_length(first.mesh, first.places[0]), 4, places=12)
        neck = bodies.body("straight necks", 1)
        n = len(neck.places[0].loops[0])
        self.assertAlmostEqual(bodies.known_length(neck.mesh, neck.places[0]), 2 * n * math.sin(math.pi / n), places=12)
        for family in ("voxel rooms", "plates with holes"):
            body = bodies.body(family, 1)
            for place in body.places:
                self.assertIn(round(bodies.known_length(body.mesh, place), 5), (4, 8))

    def test_are_the_same_every_time(self):
        for family in ("bores", "voxel rooms", "trees"):
            a, b, other = bodies.body(family, 0), bodies.body(family, 0), bodies.body(family, 0, seed=2)
            np.testing.assert_array_equal(a.mesh.points, b.mesh.points)
            np.testing.assert_array_equal(a.mesh.faces, b.mesh.faces)
            self.assertNotEqual(a.mesh.points.tobytes(), other.mesh.points.tobytes())


class Topology(unittest.TestCase):
    def test_of_what_is_no_manifold_is_refused(self):
        two_cubes = surfaces.voxel_surface([(0, 0, 0), (1, 1, 0)])
        with self.assertRaisesRegex(ValueError, "edge in common"):
            surfaces.topology(two_cubes)
        at_a_corner = surfaces.voxel_surface([(0, 0, 0), (1, 1, 1)])
        with self.assertRaisesRegex(ValueError, "fans"):
            surfaces.topology(at_a_corner)
        cube = surfaces.voxel_surface([(0, 0, 0)])
        turned = surfaces.Mesh(cube.points, np.concatenate([cube.faces[:1, ::-1], cube.faces[1:]]))
        with self.assertRaisesRegex(ValueError, "same direction"):
            surfaces.topology(turned)

    def test_counts_holes_and_components(self):
        cube = surfaces.voxel_surface([(0, 0, 0), (5, 0, 0)])
        self.assertEqual(surfaces.topology(cube), surfaces.Topology(2, 0, 0))
        self.assertEqual(surfaces.topology(surfaces.Mesh(cube.points, cube.faces[1:])), surfaces.Topology(2, 0, 1))


def square(x, y=(0, 1), z=(0, 1)):
    return np.array([(x, y[0], z[0]), (x, y[1], z[0]), (x, y[1], z[1]), (x, y[0], z[1])], float)


class Score(unittest.TestCase):
    """On two boxes, of side 3 and 2, that a tube of length 4 joins, from x = 3 to x = 7, with y and z from 0 to 1."""

    @classmethod
    def setUpClass(cls):
        cells = bodies.box((0, 0, 0), (3, 3, 3)) + bodies.box((3, 0, 0), (4, 1, 1)) + bodies.box((7, 0, 0), (2, 2, 2))
        mesh = surfaces.voxel_surface(cells)
        place = bodies.section_place(mesh, (2, 0.5, 0.5), (8, 0.5, 0.5), "object")
        cls.body = bodies.Body("boxes with a tube", "hand_made", "plain", mesh, [place], bodies.BALL)

    def counts(self, *curves):
        result = score.score(self.body, list(curves))
        return tuple(result[key] for key in ("found", "near", "duplicates", "extras", "off_surface"))

    def test_counts_a_curve_around_the_tube(self):
        self.assertEqual(self.counts(square(4.25)), (1, 0, 0, 0, 0))
        self.assertEqual(self.counts(square(4.25)[::-1]), (1, 0, 0, 0, 0))

    def test_counts_nothing(self):
        self.assertEqual(self.counts(), (0, 0, 0, 0, 0))
        self.assertEqual(score.score(self.body, [])["missed"], [0])

    def test_counts_curves_of_a_place_once(self):
        self.assertEqual(self.counts(square(4.25), square(5), square(6)), (1, 0, 2, 0, 0))

    def test_allows_for_rounding_only(self):
        tilted = square(4.25)
        tilted[:2, 0] += 0.005
        self.assertLess(surfaces.length(tilted), 4 * (1 + score.ROUNDING))
        self.assertEqual(self.counts(tilted), (1, 0, 0, 0, 0))
        tilted[:2, 0] += 0.05
        self.assertEqual(self.counts(tilted), (0, 1, 0, 0, 0))

    def test_a_longer_curve_is_near(self):
        tilted = square(4.25)
        tilted[2:, 0] += 1
        self.assertEqual(self.counts(tilted), (0, 1, 0, 0, 0))
        self.assertEqual(self.counts(tilted, square(4.25)), (1, 0, 1, 0, 0))
        tilted[2:, 0] += 1.4  # sides of 1, 2.6, 1 and 2.6
        self.assertEqual(self.counts(tilted), (0, 0, 0, 1, 0))

    def test_other_curves_are_extra(self):
        around_box = square(1, (0, 3), (0, 3))
        on_tube = np.array([(4, 0.2, 1), (5, 0.2, 1), (5, 0.8, 1), (4, 0.8, 1)], float)
        beyond_the_end = square(8.5, (0, 2), (0, 2))
        self.assertEqual(self.counts(around_box, on_tube, beyond_the_end), (0, 0, 0, 3, 0))

    def test_a_curve_off_the_surface_finds_nothing(self):
        inside = square(4.25, (0.1, 0.9), (0.1, 0.9))
        outside = square(4.25, (-0.01, 1.01), (-0.01, 1.01))
        corners_cut = square(4.25)[[0, 1, 2]]
        self.assertEqual(self.counts(inside, outside, corners_cut), (0, 0, 0, 3, 3))

    def test_twice_around_is_not_once_around(self):
        self.assertFalse(score.encircles(np.concatenate([square(4.25), square(4.5)]), self.body.places[0]))

    def test_a_curve_beyond_the_ends_of_the_axis_does_not_encircle_it(self):
        for x, expected in ((1.5, False), (2.5, True), (7.5, True), (8.5, False)):
            self.assertEqual(score.encircles(square(x, (0, 2), (0, 2)), self.body.places[0]), expected)

    def test_reads_both_formats(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "curves")
            with open(path, "w", encoding="ascii") as file:
                file.write("5 4 0 0 4 1 0 4 1 1 4 0 1 4 0 0\n\n3 0 0 0 1 0 0 1 1 0\n")
            curves = score.read_curves(path)  # the second one is open
            self.assertEqual(len(curves), 1)
            np.testing.assert_array_equal(curves[0], square(4))
            with open(path, "w", encoding="ascii") as file:
                json.dump({"format": "constrictions/1", "constrictions": [{"points": square(4).tolist()}]}, file)
            np.testing.assert_array_equal(score.read_curves(path), [square(4)])
            with open(path, "w", encoding="ascii") as file:
                file.write("3 0 0 0 1 0 0\n")
            with self.assertRaises(ValueError):
                score.read_curves(path)


class Sections(unittest.TestCase):
    def test_find_a_straight_neck(self):
        body = bodies.body("straight necks", 0)
        result = score.score(body, plane_sections.find(body.mesh, 32))
        self.assertEqual((result["found"], result["extras"]), (1, 0))

    def test_find_nothing_in_a_box(self):
        self.assertEqual(plane_sections.find(surfaces.voxel_surface(bodies.box((0, 0, 0), (3, 2, 1))), 16), [])


class Command(unittest.TestCase):
    """The whole way, with programs in place of the one that is to be measured."""

    def run_with(self, command, *options):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "results.json")
            words = [sys.executable, os.path.join(FOLDER, "run.py"), "--quick", "--command", command, "--json", path]
            done = subprocess.run([*words, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                  check=True)
            with open(path, encoding="utf-8") as file:
                return done.stdout, json.load(file)

    def test_counts_an_empty_answer(self):
        text, results = self.run_with("sh -c 'test -s {mesh} && : > {out}'", "--family", "bores")
        self.assertEqual(results["families"]["bores"]["places"], 5)
        self.assertEqual(results["families"]["bores"]["found"], 0)
        self.assertEqual(results["families"]["bores"]["failed"], 0)
        self.assertIn("together", text)

    def test_counts_failures(self):
        _, results = self.run_with("sh -c 'exit 7' {mesh} {out}", "--family", "bores")
        self.assertEqual(results["families"]["together"]["failed"], 5)
        self.assertIn("exit code 7", results["bodies"][0]["error"])

    def test_compares_programs_on_the_bodies_that_all_have(self):
        with tempfile.TemporaryDirectory() as folder:
            one = {"family": "bores", "error": None, "seconds": 0.5, "places": 3, "found": 2, "near": 1, "extras": 4,
                   "duplicates": 0}
            paths = [os.path.join(folder, name) for name in "ab"]
            for path, names in zip(paths, ("pq", "qr")):
                with open(path, "w", encoding="utf-8") as file:
                    json.dump({"bodies": [dict(one, body=name) for name in names]}, file)
            for line in run.compare([f"x={paths[0]}", f"y={paths[0]},{paths[1]}"])[2:]:
                self.assertEqual(line.replace(" ", "").split("|")[2:-1], ["2", "6", *["4", "2", "8", "1.0"] * 2])
            self.assertIn("| bores    |      1 |      3 |", run.compare([f"x={paths[0]}", f"y={paths[1]}"])[2])

    @unittest.skipUnless("CONSTRICTIONS_PROGRAM" in os.environ, "no program is given")
    def test_counts_what_the_program_finds(self):
        command = os.environ["CONSTRICTIONS_PROGRAM"] + " detect {mesh} --json {out} --quiet"
        for family in ("straight necks", "convex"):
            _, results = self.run_with(command, "--family", family)
            together = results["families"]["together"]
            self.assertEqual((together["failed"], together["found"], together["extras"]), (0, together["places"], 0))

    def test_writes_the_set(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, os.path.join(FOLDER, "run.py"), "--write", folder, "--quick", "--family",
                            "straight necks"], check=True)
            mesh = plane_sections.read_off(os.path.join(folder, "straight_necks_00.off"))
            body = bodies.body("straight necks", 0)
            np.testing.assert_array_equal(mesh.points, body.mesh.points)
            np.testing.assert_array_equal(mesh.faces, body.mesh.faces)
            with open(os.path.join(folder, "straight_necks_00.truth.json"), encoding="ascii") as file:
                place = json.load(file)["places"][0]
            self.assertEqual(place["length"], max(surfaces.length(np.array(loop)) for loop in place["loops"]))

    def test_checks_its_options(self):
        for options in ([], ["--command", "true {mesh}"]):
            done = subprocess.run([sys.executable, os.path.join(FOLDER, "run.py"), *options], stderr=subprocess.DEVNULL,
                                  check=False)
            self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
