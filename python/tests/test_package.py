# SPDX-License-Identifier: GPL-3.0-or-later
"""The package around the module: what it says of itself, its stubs, its examples."""

import ast
import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest
from meshes import read_off, write_off, write_ply

import constrictions

PACKAGE = Path(constrictions.__file__).parent
EXAMPLES = Path(__file__).parents[1] / "examples"


def public(names):
    return {name for name in names if not name.startswith("_") or name in ("__len__", "__getitem__", "__iter__")}


def test_everything_has_documentation():
    assert constrictions.__doc__ and constrictions.__version__
    for name in constrictions.__all__:
        value = getattr(constrictions, name)
        if not isinstance(value, type):
            continue
        assert value.__module__ == "constrictions"
        assert value.__doc__, name
        for member in vars(value):
            if not member.startswith("_"):
                assert getattr(value, member).__doc__, f"{name}.{member}"


def test_stubs_have_what_the_module_has():
    stubs = ast.parse((PACKAGE / "__init__.pyi").read_text())
    classes = {node.name: node for node in stubs.body if isinstance(node, ast.ClassDef)}
    assert set(classes) == {name for name in constrictions.__all__ if name[0] != "_"}
    assert (PACKAGE / "py.typed").exists()
    for name, node in classes.items():
        if name == "InvalidInput":
            continue
        declared = public(item.name for item in node.body if isinstance(item, ast.FunctionDef))
        assert declared == public(vars(getattr(constrictions, name))), name


def test_stubs_have_the_arguments_that_are_documented():
    stubs = ast.parse((PACKAGE / "__init__.pyi").read_text())
    (surface,) = [node for node in stubs.body if isinstance(node, ast.ClassDef) and node.name == "Surface"]
    for function in surface.body:
        if function.name.startswith("_") or function.decorator_list:
            continue
        documented = getattr(constrictions.Surface, function.name).__doc__
        first_line = documented.split(")")[0]
        for argument in function.args.args[1:] + function.args.kwonlyargs:
            assert argument.arg in first_line, f"{function.name}: {argument.arg}"


@pytest.mark.parametrize("example", sorted(path.name for path in EXAMPLES.glob("*.py")))
def test_examples_run(example, tmp_path):
    path = EXAMPLES / example
    text = path.read_text()
    assert len(text.splitlines()) <= 30
    for module in "meshio", "trimesh", "pyvista", "paraview":
        if (f"import {module}" in text or f"from {module} import" in text) and importlib.util.find_spec(module) is None:
            pytest.skip(f"{module} is not installed")
    arguments = []
    if "sys.argv" in text:
        name, output = "cactus.off", "out.vtu" if "import meshio" in text else "out.ply"
        if "paraview" in text or "pyvista" in text:
            name, output = "cactus.ply", "out.vtp"
        write = write_ply if name.endswith("ply") else write_off
        write(tmp_path / name, *read_off("cactus.off"))
        arguments = [name, output]
    folders = [str(PACKAGE.parent), *filter(None, [os.environ.get("PYTHONPATH")])]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(folders)}
    process = subprocess.run(
        [sys.executable, path, *arguments], stdout=subprocess.PIPE, check=True, env=environment, cwd=tmp_path, text=True
    )
    for line in text.splitlines():
        if line.startswith("# prints: "):
            assert line[len("# prints: ") :] in process.stdout
