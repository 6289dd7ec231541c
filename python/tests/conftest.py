# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh that several tests use, and its curves."""

import pytest
from meshes import read_off

import constrictions


@pytest.fixture(scope="session")
def cactus():
    return constrictions.Surface(*read_off("cactus.off"))


@pytest.fixture(scope="session")
def found(cactus):
    return cactus.detect()
