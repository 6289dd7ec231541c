# SPDX-License-Identifier: GPL-3.0-or-later
"""A surface that is prepared once, and kept in a file."""

import os
import subprocess

import numpy as np
import pytest
from meshes import FOLDER, read_off

import constrictions

PROGRAM = os.environ.get("CONSTRICTIONS_PROGRAM")


def description(curves):
    return [(c.length, c.prominence, c.certificate, c.points.tolist()) for c in curves]


def answers(surface):
    place = surface.vertices[100]
    loop = surface.girth(place)[0]
    return (
        description(surface.detect()),
        description(surface.detect(all=True, certify=False)),
        description(surface.near(place)),
        (loop.length, loop.points.tolist()),
        surface.detect(min_prominence=0.5).statistics,
    )


def test_answers_are_the_same_from_a_file(tmp_path):
    surface = constrictions.Surface(*read_off("cactus.off"))
    expected = answers(surface)
    stages = []
    surface.save_prepared(tmp_path / "cactus.prepared", progress=lambda stage, done, steps: stages.append(stage))
    assert "simplification" in stages
    assert answers(surface) == expected
    other = constrictions.Surface(*read_off("cactus.off"))
    other.load_prepared(str(tmp_path / "cactus.prepared"))
    assert answers(other) == expected
    other.save_prepared(tmp_path / "again.prepared")
    assert (tmp_path / "again.prepared").read_bytes() == (tmp_path / "cactus.prepared").read_bytes()


def test_a_file_that_does_not_fit_is_refused_and_changes_nothing(tmp_path):
    V, F = read_off("cactus.off")
    constrictions.Surface(V, F).save_prepared(tmp_path / "cactus.prepared")
    V = V.copy()
    V[7, 2] = np.nextafter(V[7, 2], 1)
    moved = constrictions.Surface(V, F)
    expected = answers(moved)
    with pytest.raises(ValueError, match="query file, byte .*: prepared for another mesh"):
        moved.load_prepared(tmp_path / "cactus.prepared")
    (tmp_path / "text").write_text("no such thing\n")
    with pytest.raises(ValueError, match="not the file of a prepared mesh"):
        moved.load_prepared(tmp_path / "text")
    with pytest.raises(FileNotFoundError):
        moved.load_prepared(tmp_path / "none")
    with pytest.raises(OSError):
        moved.save_prepared(tmp_path / "none" / "file")
    assert answers(moved) == expected


@pytest.mark.skipif(PROGRAM is None, reason="CONSTRICTIONS_PROGRAM does not name the program")
def test_the_program_writes_the_same_file(tmp_path):
    surface = constrictions.Surface(*read_off("cactus.off"))
    surface.save_prepared(tmp_path / "module")
    arguments = [PROGRAM, "prepare", FOLDER / "cactus.off", "-o", tmp_path / "program", "--quiet"]
    subprocess.run(arguments, check=True)
    assert (tmp_path / "module").read_bytes() == (tmp_path / "program").read_bytes()
