# SPDX-License-Identifier: GPL-3.0-or-later
"""The programs that are measured: their packages, the formats that they are tried with, how they are run."""
import os
import pathlib
import shutil
import subprocess

import packages

ADAPTERS = pathlib.Path(__file__).parent / "adapters"


class Program:
    """run() lets it read a file, say what it holds (as adapters/held.py does) and write it again. Programs of the
    command line say nothing, and convert."""

    def __init__(self, name, version, meshes, curves, parts):
        self.name, self.version, self.full_name = name, version, "%s %s" % (name, version)
        self.meshes, self.curves, self.parts = meshes, curves, parts

    def commands(self, source, held, target):
        raise NotImplementedError

    def run(self, jobs):
        """Reads and writes the files of each job, (source, held, target). The line of each that tells why it fails; an
        empty text if it does not."""
        messages = []
        for job in jobs:
            message = ""
            for command, environment in self.commands(*job):
                message = message or failure(command, environment)
            messages.append(message)
        return messages


def failure(command, environment):
    try:
        done = subprocess.run(command, env=environment, capture_output=True, text=True, errors="replace",
                              stdin=subprocess.DEVNULL, timeout=900)
    except subprocess.TimeoutExpired:
        return "no end after a quarter of an hour"
    if not done.returncode:
        return ""
    lines = [line.strip() for line in (done.stdout + done.stderr).splitlines()]
    lines = [line for line in lines if line.lower().strip(": ") not in ("", "error")]
    errors = [line for line in lines if "Assertion" in line or "error" in line.lower()]
    line = (errors or lines or ["exit code %d" % done.returncode])[-1]
    return line[max(line.find("Assertion"), 0):].replace("what():  ", "")


class Python_program(Program):
    """A module of the Python of a Debian release."""

    def __init__(self, name, version, release, debian, adapter, *formats):
        super().__init__(name, version, *formats)
        self.release, self.debian, self.adapter = release, debian, adapter

    def install(self, folder):
        self.root = packages.Debian(folder, self.release).unpack(self.name.lower(), self.debian)

    def run(self, jobs):
        python = {12: "usr/bin/python3.11", 13: "usr/bin/python3.13"}[self.release]
        messages = []
        while len(messages) < len(jobs):
            left = jobs[len(messages):]
            failed = failure(*packages.started_by_own_linker(self.root, python, ADAPTERS / self.adapter,
                                                             *(name for job in left for name in job)))
            for _, held, _ in left:
                message = pathlib.Path(held + ".message")
                if not message.exists():
                    messages.append(failed or "it ends")
                    break
                messages.append(message.read_text())
        return messages


class Node_program(Program):
    def __init__(self, name, version, npm, adapter, *formats):
        super().__init__(name, version, *formats)
        self.npm, self.adapter = npm, adapter

    def install(self, folder):
        self.place = packages.npm(folder, self.npm)
        # Modules are looked for beside the script.
        for script in (self.adapter, "held.mjs"):
            shutil.copy(ADAPTERS / script, self.place)

    def commands(self, source, held, target):
        return [(["node", str(self.place / self.adapter), source, held, target], None)]


class Compiled_program(Program):
    """A C++ library: its headers from a Debian release, compiled by the compiler of this machine. Of the headers and
    libraries of that release only the listed ones are seen, lest its C library gets into the way."""

    def __init__(self, name, version, release, debian, adapter, headers, libraries, *formats):
        super().__init__(name, version, *formats)
        self.release, self.debian, self.adapter = release, debian, adapter
        self.headers, self.libraries = headers, libraries

    def install(self, folder):
        self.root = packages.Debian(folder, self.release).unpack(self.name.lower(), self.debian)
        self.program = self.root / "adapter"
        source = ADAPTERS / self.adapter
        if self.program.exists() and self.program.stat().st_mtime > source.stat().st_mtime:
            return
        for place in ("seen/include", "seen/lib"):
            shutil.rmtree(self.root / place, ignore_errors=True)
            (self.root / place).mkdir(parents=True)
        for header in self.headers:
            (self.root / "seen/include" / pathlib.Path(header).name).symlink_to(self.root / "usr/include" / header)
        for library in self.libraries:
            name = "lib%s.so" % library
            (self.root / "seen/lib" / name).symlink_to(self.root / "usr/lib" / packages.TRIPLET / name)
        packages.run(["g++", "-std=c++17", "-O0", "-frounding-math", "-w",
                      "-I%s" % (self.root / "seen/include"), str(source), "-o", str(self.program),
                      "-L%s" % (self.root / "seen/lib"), "-Wl,--allow-shlib-undefined"] +
                     ["-l" + name for name in self.libraries], self.root / "compile.log")

    def commands(self, source, held, target):
        return [packages.started_by_own_linker(self.root, "adapter", source, held, target)]


class Command_line(Program):
    """Programs that convert: lines(source, target) lists their command lines."""

    def __init__(self, name, version, release, debian, lines, *formats):
        super().__init__(name, version, *formats)
        self.release, self.debian, self.lines = release, debian, lines

    def install(self, folder):
        self.root = packages.Debian(folder, self.release).unpack(self.name.lower(), self.debian)

    def commands(self, source, held, target):
        return [packages.started_by_own_linker(self.root, "usr/bin/" + line[0], *line[1:])
                for line in self.lines(source, target)]


class Command_line_with_display(Command_line):
    """The same of a program that wants a screen. Needs root."""

    def install(self, folder):
        if os.geteuid() != 0:
            raise RuntimeError("only root can run it")
        super().install(folder)

    def commands(self, source, held, target):
        folder = pathlib.Path(source).parent
        inside = [str(pathlib.Path("/work") / pathlib.Path(name).name) for name in (source, target)]
        return [(["unshare", "--mount", "--pid", "--fork", str(ADAPTERS / "with_display.sh"), str(self.root),
                  str(folder), "/usr/bin/" + line[0], *line[1:]], None) for line in self.lines(*inside)]


class Node_command_line(Program):
    def __init__(self, name, version, npm, lines, *formats):
        super().__init__(name, version, *formats)
        self.npm, self.lines = npm, lines

    def install(self, folder):
        self.place = packages.npm(folder, self.npm)

    def commands(self, source, held, target):
        return [(["node", str(self.place / "node_modules" / line[0])] + line[1:], None)
                for line in self.lines(source, target)]


POLYGONS = ["OFF", "OBJ", "PLY", "PLY text", "STL", "STL text"]
VTK = ["VTK", "VTK text", "VTP"]
CURVES = ["OBJ", "PLY", "VTP"]
PARTS = ["parts.ply", "parts.vtp", "part_0.obj", "part_0.glb", "parts.3mf"]
SURFACE_PARTS = PARTS[:1] + PARTS[2:3]


def assimp(source, target):
    return [["assimp", "export", source, target]]


def meshlabserver(source, target):
    # What is to be saved: colours of vertices and of faces.
    return [["meshlabserver", "-i", source, "-o", target, "-m", "vc", "fc"]]


def draco(source, target):
    return [["draco_encoder", "-i", source, "-o", source + ".drc", "-qp", "0", "-cl", "10"],
            ["draco_decoder", "-i", source + ".drc", "-o", target]]


def gltfpack(source, target):
    return [["gltfpack/cli.js", "-i", source, "-o", target, "-noq"]]


XML = "@xmldom/xmldom@0.9.8"
PROGRAMS = [
    Compiled_program("CGAL", "5.5.1", 12, ["libcgal-dev=5.5.1-2"], "cgal_files.cpp",
                     ["CGAL", "boost", packages.TRIPLET + "/gmp.h", "mpfr.h"], ["gmp", "mpfr"],
                     POLYGONS + ["OBJ with a line", "PLY of 16 bits"], CURVES[:2], SURFACE_PARTS),
    Compiled_program("CGAL", "6.0.1", 13, ["libcgal-dev=6.0.1-1"], "cgal_files.cpp",
                     ["CGAL", "boost", packages.TRIPLET + "/gmp.h", "mpfr.h"], ["gmp", "mpfr"],
                     POLYGONS + ["OBJ with a line", "PLY of 16 bits"], CURVES[:2], SURFACE_PARTS),
    Compiled_program("OpenMesh", "9.0", 12, ["libopenmesh-dev=9.0-4+b1"], "openmesh_files.cpp",
                     ["OpenMesh"], ["OpenMeshCore"], POLYGONS, CURVES[:2], SURFACE_PARTS),
    Compiled_program("OpenMesh", "11.0", 13, ["libopenmesh-dev=11.0.0-2+b1"], "openmesh_files.cpp",
                     ["OpenMesh"], ["OpenMeshCore"], POLYGONS, CURVES[:2], SURFACE_PARTS),
    Python_program("VTK", "9.1.0", 12, ["python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1"], "vtk_files.py",
                   POLYGONS[1:] + VTK + ["GLB"], CURVES, PARTS[:4]),
    Python_program("VTK", "9.3.0", 13, ["python3-vtk9=9.3.0+dfsg1-4+b1"], "vtk_files.py",
                   POLYGONS[1:] + VTK + ["GLB"], CURVES, PARTS[:4]),
    Python_program("ParaView", "5.11.0", 12, ["paraview=5.11.0+dfsg-1+b1", "python3-paraview=5.11.0+dfsg-1+b1"],
                   "paraview_files.py", POLYGONS[1:] + VTK + ["GLB"], CURVES, PARTS[:4]),
    Python_program("ParaView", "5.13.2", 13, ["paraview=5.13.2+dfsg-3", "python3-paraview=5.13.2+dfsg-3"],
                   "paraview_files.py", POLYGONS[1:] + VTK + ["GLB"], CURVES, PARTS[:4]),
    Python_program("meshio", "5.0.0", 12, ["python3-meshio=7.0.0-3"], "meshio_files.py",
                   POLYGONS + VTK[:2], CURVES[:2], SURFACE_PARTS),
    Python_program("meshio", "5.3.5", 13, ["python3-meshio=7.0.0-really-5.3.5-6+deb13u1"], "meshio_files.py",
                   POLYGONS + VTK[:2], CURVES[:2], SURFACE_PARTS),
    Python_program("trimesh", "4.5.1", 13, ["python3-trimesh=4.5.1-3", "python3-scipy", "python3-networkx",
                                            "python3-lxml"], "trimesh_files.py",
                   POLYGONS + ["GLB", "3MF"], CURVES[:2], [PARTS[0]] + PARTS[2:]),
    Python_program("Open3D", "0.16.1", 12, ["python3-open3d=0.16.1+ds-2+b4"], "open3d_files.py",
                   POLYGONS + ["GLB"], CURVES[:2], [PARTS[0]] + PARTS[2:4]),
    Python_program("Open3D", "0.19.0", 13, ["python3-open3d=0.19.0-3"], "open3d_files.py",
                   POLYGONS + ["GLB"], CURVES[:2], [PARTS[0]] + PARTS[2:4]),
    Command_line("Assimp", "5.2.5", 12, ["assimp-utils=5.2.5~ds0-1+b1"], assimp,
                 POLYGONS[1:] + ["GLB", "3MF"], CURVES[:2], PARTS[:1]),
    Command_line("Assimp", "5.4.3", 13, ["assimp-utils=5.4.3+ds-2"], assimp,
                 POLYGONS[1:] + ["GLB", "3MF"], CURVES[:2], PARTS[:1]),
    Python_program("Gmsh", "4.8.4", 12, ["python3-gmsh=4.8.4+ds2-3"], "gmsh_files.py",
                   POLYGONS + VTK[:2], CURVES[:2], SURFACE_PARTS),
    Python_program("Gmsh", "4.13.1", 13, ["python3-gmsh=4.13.1+ds1-6"], "gmsh_files.py",
                   POLYGONS + VTK[:2], CURVES[:2], SURFACE_PARTS),
    Command_line_with_display("MeshLab", "2020.09", 12, ["meshlab=2020.09+dfsg1-2", "xvfb", "dash"], meshlabserver,
                              POLYGONS + ["3MF"], CURVES[:2], PARTS[:1]),
    Command_line("Draco", "1.5.5", 12, ["draco=1.5.5+dfsg-2"], draco, ["OBJ", "PLY", "PLY text"], [], [PARTS[0]]),
    Command_line("Draco", "1.5.6", 13, ["draco=1.5.6+dfsg-3+b3"], draco, ["OBJ", "PLY", "PLY text"], [], [PARTS[0]]),
    Node_program("three.js", "0.187.0", ["three@0.187.0", XML], "three_files.mjs",
                 POLYGONS[1:] + VTK + ["GLB"], CURVES, PARTS[:4]),
    Node_program("vtk.js", "37.4.3", ["@kitware/vtk.js@37.4.3", XML], "vtkjs_files.mjs",
                 POLYGONS[1:] + VTK, CURVES, PARTS[:3]),
    Node_program("manifold-3d", "3.5.4", ["manifold-3d@3.5.4"], "manifold_arrays.mjs", ["OFF"], [], []),
    Node_program("meshoptimizer", "1.3.0", ["meshoptimizer@1.3.0"], "meshoptimizer_arrays.mjs", ["OFF"], [], []),
    Node_command_line("gltfpack", "1.3.0", ["gltfpack@1.3.0"], gltfpack, ["GLB"], [], []),
    Node_program("glTF-Transform", "4.5.1", ["@gltf-transform/core@4.5.1"], "gltf_transform_files.mjs", ["GLB"], [],
                 PARTS[3:4]),
]
