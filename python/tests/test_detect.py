# SPDX-License-Identifier: GPL-3.0-or-later
"""What is found, and how it comes out."""

import math

import numpy as np
import pytest
from meshes import TETRAHEDRON, hourglass, tube

import constrictions


def test_the_waist_of_an_hourglass_is_found():
    (waist,) = constrictions.Surface(*hourglass()).detect()
    assert waist.length == pytest.approx(12 * 2 * math.sin(math.pi / 12))
    assert waist.diameter == pytest.approx(waist.length / math.pi)
    assert waist.centroid == pytest.approx([0, 0, 4])
    assert abs(waist.normal) == pytest.approx([0, 0, 1])
    assert waist.side == "object" and waist.separating and waist.certified and not waist.rim
    assert waist.certificate == "strict_constriction"
    assert waist.areas[0] == pytest.approx(waist.areas[1])
    assert len(waist) == len(waist.points) == 12
    assert sorted(waist.pivots) == list(range(48, 60))
    assert waist.prominence > 0.5 and waist.roundness > 0.9


def test_a_convex_body_has_none():
    found = constrictions.Surface(*TETRAHEDRON).detect(all=True)
    assert len(found) == 0 and list(found) == []
    assert repr(found) == "<constrictions.Constrictions: 0 curves>"
    arrays = found.as_dict()
    assert arrays["points"].shape == (0, 3) and arrays["length"].shape == (0,)
    assert arrays["areas"].shape == (0, 2) and arrays["pivot_angles"].shape == (0, 2)
    assert arrays["offsets"].tolist() == [0] and arrays["certificate"].dtype.kind == "U"


def test_a_surface_with_holes_is_taken():
    open_tube = constrictions.Surface(*hourglass(closed=False))
    (waist,) = open_tube.detect()
    assert waist.centroid == pytest.approx([0, 0, 4])
    rims = [c for c in open_tube.detect(rims=True) if c.rim]
    assert len(rims) == 2
    for rim in rims:
        assert rim.boundary_share == pytest.approx(1)
        assert np.isinf(rim.pivot_angles).any(axis=1).all()


def test_points_are_where_faces_and_barycentric_coordinates_say(cactus, found):
    for curve in found:
        corners = cactus.vertices[cactus.faces[curve.faces]]
        assert np.einsum("ki,kij->kj", curve.barycentric, corners) == pytest.approx(curve.points, abs=1e-15)
        assert curve.barycentric.sum(axis=1) == pytest.approx(1)
        assert ((curve.barycentric == 0).sum(axis=1) == 2).nonzero()[0].tolist() == curve.pivot_points.tolist()
        assert np.array_equal(cactus.vertices[curve.pivots], curve.points[curve.pivot_points])
        assert (curve.pivot_angles >= math.pi - 1e-9).all()
        steps = np.roll(curve.points, -1, axis=0) - curve.points
        assert np.linalg.norm(steps, axis=1).sum() == pytest.approx(curve.length)


def test_arrays_are_made_once_and_can_not_be_changed(found):
    curve = found[0]
    assert curve.points is curve.points and found[0] is curve
    for name, value in curve.as_dict().items():
        if isinstance(value, np.ndarray):
            assert not value.flags.writeable, name


def test_results_are_sequences(found):
    assert len(found) == 3
    assert [c.length for c in found] == [found[i].length for i in range(3)]
    assert found[-1] is found[2]
    assert found[1:] == [found[1], found[2]]
    assert sorted(found, key=lambda c: c.length)[0] is found[1]
    for i in 3, -4:
        with pytest.raises(IndexError):
            found[i]


def test_results_are_dicts_of_arrays(found, tmp_path):
    arrays = found.as_dict()
    assert set(found[0].as_dict()) < set(arrays)
    for name, value in arrays.items():
        assert isinstance(value, np.ndarray), name
    assert arrays["length"].tolist() == [c.length for c in found]
    assert arrays["centroid"].shape == (3, 3)
    assert arrays["dominated_by"].tolist() == [-1 if c.dominated_by is None else c.dominated_by for c in found]
    for group, names in {
        "offsets": ["points", "faces", "barycentric"],
        "pivot_offsets": ["pivots", "pivot_points", "pivot_angles"],
        "seed_offsets": ["seed"],
    }.items():
        offsets = arrays[group]
        for name in names:
            for i, curve in enumerate(found):
                assert np.array_equal(arrays[name][offsets[i] : offsets[i + 1]], getattr(curve, name))
    np.savez(tmp_path / "curves.npz", **arrays)
    with np.load(tmp_path / "curves.npz", allow_pickle=False) as saved:
        assert np.array_equal(saved["points"], arrays["points"])


def test_results_say_what_they_are(found):
    assert repr(found[0]) == (
        "<constrictions.Constriction: length 0.599004, prominence 0.61, object, separating, strict_constriction, "
        f"{len(found[0])} points>"
    )
    lines = repr(found).splitlines()
    assert lines[0] == "<constrictions.Constrictions: 3 curves" and lines[1].startswith("  0: length 0.599004, ")


def test_statistics_are_those_of_the_format(found):
    statistics = found.statistics
    assert statistics["collapses"] == 616 and statistics["seeds"] > 0
    assert sum(statistics["signs"].values()) > 0


def test_curves_outlive_their_surface():
    curve = constrictions.Surface(*hourglass()).detect()[0]
    assert len(curve.points) == 12


def test_thresholds_and_numbers_are_kept(cactus, found):
    assert len(cactus.detect(max_number=1)) == 1
    assert [c.length for c in cactus.detect(min_length=0.29)] == [found[0].length, found[2].length]
    assert [c.length for c in cactus.detect(max_length=0.29)] == [found[1].length]
    assert [c.length for c in cactus.detect(min_prominence=0.5)] == [found[0].length]
    everything = cactus.detect(all=True)
    assert len(everything) > 3
    assert not cactus.detect(certify=False)[0].certified


def test_near_finds_the_arm(cactus, found):
    nearest = cactus.near(found[2].centroid, max_number=1)[0]
    assert nearest.length == found[2].length
    with pytest.raises(constrictions.InvalidInput, match="the location has y = ") as raised:
        cactus.near([0, np.nan, 0])
    assert raised.value.defect == "non_finite_coordinate"
    with pytest.raises(ValueError, match="the location has 2 coordinates, it must have 3"):
        cactus.near([0, 0])
    with pytest.raises(TypeError, match="the location: the elements are of the type"):
        cactus.near(["x", "y", "z"])


def test_girth_is_measured_at_a_place(cactus, found):
    place = found[2].points[0]
    (loop,) = cactus.girth(place)
    assert loop.length == pytest.approx(found[2].length)
    assert loop.points[0] == pytest.approx(place)
    assert loop.let_go == "constriction" and loop.constriction.length == pytest.approx(found[2].length)
    assert loop.constriction.certified
    assert loop.points.shape == loop.barycentric.shape and len(loop.faces) == len(loop)
    assert "becomes a constriction" in repr(loop)
    beside = found[2].points[0] + 0.02 * found[2].normal
    (loop,) = cactus.girth(beside)
    assert not loop.closed_geodesic and min(loop.left_angle, loop.right_angle) < math.pi
    corners = cactus.vertices[cactus.faces[loop.faces]]
    assert np.einsum("ki,kij->kj", loop.barycentric, corners) == pytest.approx(loop.points)
    assert len(cactus.girth(beside, max_number=3, min_angle=0)) > 1
    assert loop.as_dict()["length"] == loop.length
    assert constrictions.Surface(*TETRAHEDRON).girth([0.3, 0.3, 0], min_angle=3.2) == []


def test_sections_are_measured_along_an_axis():
    tube = constrictions.Surface(*hourglass())
    place = tube.vertices[48]
    section = tube.section(place, [0, 0, 1])
    assert section.kind == "closed" and section.curves == 1
    ring = tube.vertices[48:60]
    assert section.length == pytest.approx(np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1).sum())
    assert section.points[0] == pytest.approx(place) and section.points[:, 2] == pytest.approx(4)
    assert section.loop.length == pytest.approx(section.length)
    assert section.as_dict()["length"] == section.length
    assert repr(section).startswith("<constrictions.PlaneSection: closed, length ")
    corner = constrictions.Surface(*TETRAHEDRON)
    touching = corner.section(corner.vertices[3], corner.vertices[3] - corner.vertices[:3].mean(axis=0))
    assert touching.kind == "point" and touching.length == 0 and touching.loop is None
    with pytest.raises(constrictions.InvalidInput, match="axis has length 0"):
        tube.section(place, [0, 0, 0])
    with pytest.raises(ValueError, match="the axis has 2 coordinates"):
        tube.section(place, [0, 1])


def test_loops_are_tightened():
    surface = constrictions.Surface(*hourglass())
    around = lambda ring: np.arange(12 * ring, 12 * ring + 12)
    neck, cap, tip = surface.tighten([around(3), around(0).tolist(), np.array([0, 1, 108], dtype=np.uint8)])
    assert neck.verdict == "constriction" and neck.curve.centroid == pytest.approx([0, 0, 4])
    assert neck.curve.seed.tolist() == around(3).tolist() and neck.curve.seed_origin == "user"
    assert math.isnan(neck.curve.prominence)
    assert cap.verdict == tip.verdict == "point" and cap.curve is None
    assert repr(tip) == "<constrictions.TightenedCurve: point>"
    assert repr(neck).startswith("<constrictions.TightenedCurve: constriction, length ")
    assert surface.tighten([]) == []


@pytest.mark.parametrize(
    "loop, message",
    [
        ([0, 1], "loop 1 has 2 vertices; a closed path has at least 3"),
        ([], "loop 1 has 0 vertices; a closed path has at least 3"),
        ([0, 1, 50], "loop 1 is not a path of mesh edges: no edge joins vertices 1 and 50"),
        ([0, 1, 110], "invalid vertex index: loop 1 refers to vertex 110 of 110"),
        ([0, 1, -1], "invalid vertex index: loop 1 refers to vertex -1 of 110"),
    ],
)
def test_loops_that_are_none_are_refused(loop, message):
    surface = constrictions.Surface(*hourglass())
    with pytest.raises(constrictions.InvalidInput) as raised:
        surface.tighten([range(12), loop])
    assert str(raised.value) == message and raised.value.element == 1


def test_loops_of_other_types_are_refused():
    surface = constrictions.Surface(*hourglass())
    with pytest.raises(TypeError, match="loop 0: the elements are of the type float64, they must be integers"):
        surface.tighten([[0.0, 1.0, 2.0]])
    with pytest.raises(ValueError, match=r"loop 0: the shape is \(\), it must be \(n,\)"):
        surface.tighten(range(12))
    with pytest.raises(TypeError):
        surface.tighten(3)


def test_a_long_tube_has_all_its_necks():
    necks = constrictions.Surface(*tube([1, 3, 1, 3, 1, 3, 1])).detect()
    assert len(necks) == 2
    assert sorted(c.centroid[2] for c in necks) == pytest.approx([2, 4])
