# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done with curves: certificates, parts, splits."""

import numpy as np
import pytest
from meshes import hourglass, read_off, tube

import constrictions


def test_curves_are_certified(cactus, found):
    for curve in found:
        certificate = cactus.certify(curve)
        assert str(certificate) == curve.certificate == "strict_constriction"
        assert certificate.verdict == "strict_constriction" and certificate.certified
        assert certificate.flat_band_width == 0 and sum(certificate.signs.values()) > 0
        assert repr(certificate) == "<constrictions.Certificate: strict_constriction>"


def test_curves_are_certified_from_their_arrays(cactus, found):
    for curve in cactus.detect(all=True):
        certificate = cactus.certify((curve.faces, curve.barycentric))
        assert str(certificate) == curve.certificate
    arrays = found.as_dict()
    begin, end = arrays["offsets"][1:3]
    assert cactus.certify((arrays["faces"][begin:end].tolist(), arrays["barycentric"][begin:end].tolist())).certified


def test_a_curve_that_can_be_shortened_is_refuted():
    surface = constrictions.Surface(*hourglass())
    ring = 12 + np.arange(12)  # the widest
    faces = [np.flatnonzero((surface.faces == v).any(axis=1))[0] for v in ring]
    barycentric = (surface.faces[faces] == ring[:, None]).astype(float)
    certificate = surface.certify((faces, barycentric))
    assert not certificate.certified and certificate.verdict == "angle_below_pi"
    assert str(certificate).startswith("not_certified: the side angle on the ")
    assert certificate.point == 0 and certificate.side in ("left", "right")
    broken = surface.certify((faces[::2], barycentric[::2]))
    assert broken.verdict == "not_a_closed_curve"


@pytest.mark.parametrize("barycentric", [(0.2, 0.3, 0.5), (0.5, 0.6, -0.1), (0, 0, 0), (np.nan, 0, 1), (0, -1, 2)])
def test_points_on_no_edge_are_refused(cactus, found, barycentric):
    coordinates = found[0].barycentric.copy()
    coordinates[3] = barycentric
    with pytest.raises(constrictions.InvalidInput, match="point 3 of the curve is on no edge") as raised:
        cactus.certify((found[0].faces, coordinates))
    assert raised.value.defect == "invalid_location" and raised.value.element == 3


@pytest.mark.parametrize("face", [-1, 1236, 2**40])
def test_points_in_no_face_are_refused(cactus, found, face):
    faces = found[0].faces.copy()
    faces[2] = face
    with pytest.raises(constrictions.InvalidInput, match=f"point 2 of the curve is in face {face} of 1236"):
        cactus.certify((faces, found[0].barycentric))


def test_what_is_no_curve_is_refused(cactus, found):
    for curve in None, 3, found[0].points, [found[0]]:
        with pytest.raises(TypeError, match="the curve is neither a Constriction nor a pair of arrays"):
            cactus.certify(curve)
    with pytest.raises(ValueError, match="the curve has 3 faces, and barycentric coordinates of 2 points"):
        cactus.certify(([1, 2, 3], np.ones((2, 3))))
    with pytest.raises(ValueError, match="the curve has no points"):
        cactus.certify(([], np.empty((0, 3))))
    with pytest.raises(TypeError, match="the faces of the curve: the elements are of the type float64"):
        cactus.certify(([1.0], np.ones((1, 3))))


def test_curves_of_another_surface_are_refused(found):
    other = constrictions.Surface(*read_off("cactus.off"))
    with pytest.raises(ValueError, match="the curve is a constriction of another surface"):
        other.certify(found[0])
    with pytest.raises(ValueError, match="curve 1 is a constriction of another surface"):
        other.segment([other.detect()[0], found[0]])


def test_caps_and_sides_are_measured(cactus, found):
    assert np.isnan(found[0].cap_area) and np.isnan(found[0].side_girths).all()
    measured = cactus.measure(found)
    assert [c.length for c in measured] == [c.length for c in found]
    for c in measured:
        assert 0 < c.cap_area < 1.1 * c.length**2 / (4 * np.pi)
        assert c.side_girths.shape == (2,) and (c.side_girths > c.length).all()
    assert measured.as_dict()["cap_area"].shape == (3,)
    alone = cactus.measure([(found[0].faces, found[0].barycentric)])
    assert alone[0].side_girths == pytest.approx(measured[0].side_girths)
    with pytest.raises(constrictions.InvalidInput):
        cactus.measure([(found[0].faces[:5], found[0].barycentric[:5])])


def test_parts_are_told(cactus, found):
    parts = cactus.segment(found)
    assert len(parts) == 4 and repr(parts) == "<constrictions.Segmentation: 4 parts, 1236 faces>"
    assert parts.labels.shape == (1236,) and set(parts.labels) == {0, 1, 2, 3}
    a, b, c = (cactus.vertices[cactus.faces[:, i]] for i in range(3))
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    volumes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    assert parts.areas.sum() == pytest.approx(areas.sum())
    assert parts.volumes.sum() == pytest.approx(volumes.sum())
    assert parts.genera.tolist() == [0, 0, 0, 0] and parts.boundaries.sum() == 6
    assert sorted(parts.meeting_curves) == [0, 1, 2] and parts.meeting_parts.shape == (3, 2)
    assert parts.meeting_lengths[np.argsort(parts.meeting_curves)] == pytest.approx([curve.length for curve in found])
    assert parts.used.all() and parts.crossed.tolist() == [-1, -1, -1]
    assert set(parts.as_dict()) >= {"labels", "areas", "volumes"}
    assert np.shares_memory(parts.labels, parts.labels) and not parts.labels.flags.writeable


def test_the_number_of_parts_can_be_bounded(cactus, found):
    parts = cactus.segment(found, parts=2)
    assert len(parts) == 2 and parts.used.tolist() == [True, False, False]
    assert len(cactus.segment([])) == 1
    assert cactus.split(found, parts=2).labels.max() == 1


def test_a_curve_that_is_not_closed_does_not_cut(cactus, found):
    with pytest.raises(constrictions.InvalidInput):
        cactus.segment([(found[0].faces[:5], found[0].barycentric[:5])])


def check_split(surface, curves):
    """The split of a surface, with all that must be true of one."""
    split = surface.split(curves)
    n, m = len(surface.vertices), len(surface.faces)
    assert np.array_equal(split.vertices[:n], surface.vertices)
    assert len(split.vertices) == n + sum((c.barycentric > 0).sum(axis=1).tolist().count(2) for c in curves)
    untouched = np.flatnonzero(np.bincount(split.parents, minlength=m) == 1)
    assert np.array_equal(split.faces[untouched], surface.faces[untouched])
    again = constrictions.Surface(split.vertices, split.faces)  # it is a surface
    directed = {tuple(edge) for i in range(3) for edge in np.roll(split.faces, i, axis=1)[:, :2].tolist()}
    for curve, path in zip(curves, split.curves):
        begin = np.linalg.norm(split.vertices[path] - curve.points[0], axis=1).argmin()
        assert split.vertices[np.roll(path, -begin)] == pytest.approx(curve.points, abs=1e-12)
        assert all(edge in directed for edge in zip(path.tolist(), np.roll(path, -1).tolist()))
    assert split.used.all() and (split.crossed == -1).all()
    area = lambda V, F: np.linalg.norm(np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]]), axis=1) / 2
    areas = np.bincount(split.parents, area(split.vertices, split.faces), minlength=m)
    assert areas == pytest.approx(area(surface.vertices, surface.faces))
    return split, again


def test_a_surface_is_split(cactus, found):
    split, again = check_split(cactus, list(found))
    parts = cactus.segment(found)
    areas = np.linalg.norm(
        np.cross(
            split.vertices[split.faces[:, 1]] - split.vertices[split.faces[:, 0]],
            split.vertices[split.faces[:, 2]] - split.vertices[split.faces[:, 0]],
        ),
        axis=1,
    )
    assert sorted(np.bincount(split.labels, areas) / 2) == pytest.approx(sorted(parts.areas))
    assert repr(split) == f"<constrictions.Split: {len(split.vertices)} vertices, {len(split.faces)} faces>"
    # the curves run along edges now, and are what they were
    tightened = again.tighten(split.curves)
    assert [t.curve.length for t in tightened] == pytest.approx([c.length for c in found])
    assert set(split.as_dict()) == {"vertices", "faces", "labels", "parents", "curves", "used", "crossed"}


def test_a_surface_with_holes_is_split():
    surface = constrictions.Surface(*hourglass(closed=False))
    split, _ = check_split(surface, list(surface.detect()))
    assert len(split.faces) == len(surface.faces)  # along edges, nothing is to be split
    assert np.bincount(split.labels).tolist() == [96, 96]


def test_arrays_outlive_a_split(cactus, found):
    vertices = cactus.split(found).vertices
    assert np.isfinite(vertices).all()


def test_a_curve_around_a_handle_does_not_separate():
    around, along = 8, 24
    u = 2 * np.pi * np.arange(along) / along
    v = 2 * np.pi * np.arange(around) / around
    radius = 3 + np.cos(v)[None, :] * (0.6 + 0.3 * np.cos(2 * u))[:, None]
    V = np.stack(
        [
            radius * np.cos(u)[:, None],
            radius * np.sin(u)[:, None],
            np.sin(v)[None, :] * (0.6 + 0.3 * np.cos(2 * u))[:, None],
        ],
        axis=-1,
    ).reshape(-1, 3)
    at = lambda i, j: (i % along) * around + j % around
    F = [
        face
        for i in range(along)
        for j in range(around)
        for face in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))
    ]
    surface = constrictions.Surface(V, F)
    curves = [c for c in surface.detect() if not c.separating]
    assert len(curves) >= 2 and curves[0].genera.tolist() == [0, 0]
    assert len(surface.segment(curves[:1])) == 1
