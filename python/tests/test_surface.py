# SPDX-License-Identifier: GPL-3.0-or-later
"""What arrays can be made a surface, and what is said of those that can not."""

import numpy as np
import pytest
from meshes import TETRAHEDRON, hourglass

import constrictions


def test_arrays_come_back_as_they_went_in():
    V, F = hourglass()
    surface = constrictions.Surface(V, F)
    assert np.array_equal(surface.vertices, V)
    assert np.array_equal(surface.faces, F)
    assert surface.vertices.dtype == np.float64 and surface.faces.dtype == np.int64
    assert repr(surface) == f"<constrictions.Surface: {len(V)} vertices, {len(F)} faces>"


def test_arrays_out_are_not_copied_and_can_not_be_changed():
    surface = constrictions.Surface(*hourglass())
    assert np.shares_memory(surface.vertices, surface.vertices)
    assert surface.faces is surface.faces
    for array in surface.vertices, surface.faces:
        with pytest.raises(ValueError):
            array[0, 0] = 0


def test_an_array_out_outlives_its_surface():
    V, F = hourglass()
    vertices = constrictions.Surface(V, F).vertices
    assert np.array_equal(vertices, V)


def test_a_surface_does_not_change_with_its_arrays():
    V, F = hourglass()
    surface = constrictions.Surface(V, F)
    before = surface.detect().as_dict()["points"]
    expected = V.copy()
    V[:] = np.nan
    F[:] = 0
    assert np.array_equal(surface.vertices, expected)
    assert np.array_equal(surface.detect().as_dict()["points"], before)


@pytest.mark.parametrize("dtype", [np.float32, np.float16, np.int64, np.int8, ">f8"])
def test_coordinates_of_other_types_are_converted(dtype):
    V, F = TETRAHEDRON
    assert np.array_equal(constrictions.Surface(V.astype(dtype), F).vertices, V)


@pytest.mark.parametrize("dtype", [np.int8, np.uint16, np.int32, np.uint32, np.uint64, ">i4"])
def test_indices_of_any_integer_type_are_taken(dtype):
    V, F = TETRAHEDRON
    assert np.array_equal(constrictions.Surface(V, F.astype(dtype)).faces, F)


def test_lists_are_taken():
    V, F = TETRAHEDRON
    assert np.array_equal(constrictions.Surface(V.tolist(), F.tolist()).faces, F)


def test_arrays_need_not_be_contiguous():
    V, F = hourglass()
    wide = np.full((2 * len(V), 5), np.nan)
    wide[::2, 1:4] = V
    surface = constrictions.Surface(wide[::2, 1:4], np.asfortranarray(F))
    assert np.array_equal(surface.vertices, V) and np.array_equal(surface.faces, F)
    reverse = constrictions.Surface(V[:, ::-1], F[:, ::-1])
    assert np.array_equal(reverse.vertices, V[:, ::-1])
    assert np.array_equal(reverse.faces, F[:, ::-1])


@pytest.mark.parametrize("shape", [(12,), (4, 2), (3, 4), (2, 2, 3), (0,)])
def test_coordinates_of_another_shape_are_refused(shape):
    with pytest.raises(ValueError, match=r"^V: the shape is \(.*\), it must be \(n, 3\)$"):
        constrictions.Surface(np.zeros(shape), TETRAHEDRON[1])


@pytest.mark.parametrize("shape", [(12,), (3, 4), (0,)])
def test_faces_of_another_shape_are_refused(shape):
    with pytest.raises(ValueError, match=r"^F: the shape is \(.*\), it must be \(n, 3\)$"):
        constrictions.Surface(TETRAHEDRON[0], np.zeros(shape, dtype=int))


@pytest.mark.parametrize("dtype", [complex, object, bool, np.longdouble, "U3"])
def test_coordinates_of_no_real_numbers_are_refused(dtype):
    with pytest.raises(TypeError, match="^V: the elements are of the type .*, they must be float64$"):
        constrictions.Surface(TETRAHEDRON[0].astype(dtype), TETRAHEDRON[1])


@pytest.mark.parametrize("dtype", [float, np.float32, bool, object])
def test_indices_of_no_integers_are_refused(dtype):
    with pytest.raises(TypeError, match="^F: the elements are of the type .*, they must be integers$"):
        constrictions.Surface(TETRAHEDRON[0], TETRAHEDRON[1].astype(dtype))


def refusal(V, F):
    with pytest.raises(constrictions.InvalidInput) as raised:
        constrictions.Surface(V, F)
    assert isinstance(raised.value, ValueError)
    return raised.value.defect, raised.value.element, str(raised.value)


def test_empty_arrays_are_refused():
    assert refusal(np.empty((0, 3)), np.empty((0, 3), dtype=int))[0] == "empty_mesh"
    assert refusal(TETRAHEDRON[0], np.empty((0, 3), dtype=int))[:2] == ("empty_mesh", 0)


@pytest.mark.parametrize("coordinate", [np.nan, np.inf, -np.inf])
def test_a_coordinate_that_is_no_finite_number_is_refused(coordinate):
    V = TETRAHEDRON[0].copy()
    V[2, 1] = coordinate
    defect, element, message = refusal(V, TETRAHEDRON[1])
    assert (defect, element) == ("non_finite_coordinate", 2)
    assert message.startswith("non-finite coordinate: vertex 2 has y = ")


@pytest.mark.parametrize("index", [4, -1, 2**32 - 1, 2**32, 2**40])
def test_an_index_of_no_vertex_is_refused(index):
    F = TETRAHEDRON[1].copy()
    F[3, 1] = index
    assert refusal(TETRAHEDRON[0], F) == (
        "invalid_vertex_index",
        3,
        f"invalid vertex index: face 3 refers to vertex {index} of 4",
    )


def test_a_face_with_a_vertex_twice_is_refused():
    F = TETRAHEDRON[1].copy()
    F[1] = (0, 0, 3)
    assert refusal(TETRAHEDRON[0], F)[:2] == ("zero_length_edge", 1)


def test_an_edge_of_length_zero_is_refused():
    V = TETRAHEDRON[0].copy()
    V[3] = V[2]
    assert refusal(V, TETRAHEDRON[1])[:2] == ("zero_length_edge", 2)


def test_an_edge_with_three_faces_is_refused():
    V, F = TETRAHEDRON
    V = np.concatenate([V, [(1, 1, 1)]])
    F = np.concatenate([F, [(0, 1, 4)]])
    defect, element, message = refusal(V, F)
    assert defect == "non_manifold_edge" and "between vertices" in message and f"face {element}" in message


def test_a_face_that_is_turned_round_is_refused():
    F = TETRAHEDRON[1].copy()
    F[2] = F[2, ::-1]
    assert refusal(TETRAHEDRON[0], F)[0] == "inconsistent_orientation"


def test_a_vertex_with_two_fans_is_refused():
    V, F = TETRAHEDRON
    V = np.concatenate([V, -V[1:]])
    other = np.where(F == 0, 0, F + 3)[:, ::-1]
    assert refusal(V, np.concatenate([F, other]))[:2] == ("non_manifold_vertex", 0)


def test_isolated_vertices_keep_their_numbers():
    V, F = hourglass()
    V, F = np.concatenate([[(9, 9, 9)], V, [(8, 8, 8)]]), F + 1
    surface = constrictions.Surface(V, F)
    assert np.array_equal(surface.vertices, V)
    (waist,) = surface.detect()
    split = surface.split([waist])
    assert np.array_equal(split.vertices[: len(V)], V)
    with pytest.raises(constrictions.InvalidInput, match="loop 0 .* vertex 0 is isolated"):
        surface.tighten([[0, 1, 2]])


def test_wrong_calls_are_told():
    with pytest.raises(TypeError):
        constrictions.Surface()
    with pytest.raises(TypeError):
        constrictions.Surface(*TETRAHEDRON).detect(0.1)
    with pytest.raises(TypeError):
        constrictions.Surface(*TETRAHEDRON).detect(min_prominense=0.1)
    with pytest.raises(TypeError):
        constrictions.Surface(*TETRAHEDRON).detect(max_number=-1)
