# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets CMake build the module, in the folder of the whole project: pip install ./python"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

project = Path(__file__).resolve().parent.parent
version = re.search(r"VERSION (\d+\.\d+\.\d+)", (project / "CMakeLists.txt").read_text()).group(1)


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        build = Path(self.build_temp).resolve()
        options = [
            "-DCMAKE_BUILD_TYPE=Release",
            f"-DPython_EXECUTABLE={sys.executable}",
            "-DWITH_TOOLS=OFF",
            "-DWITH_EXAMPLES=OFF",
            "-DWITH_TESTS=OFF",
            "-DCONSTRICTIONS_INSTALL=OFF",
        ]
        try:
            import pybind11

            options.append(f"-Dpybind11_DIR={pybind11.get_cmake_dir()}")
        except ImportError:
            pass  # CMake finds that of the system
        options += os.environ.get("CMAKE_ARGS", "").split()
        subprocess.run(["cmake", "-S", project, "-B", build, *options], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "constrictions_python"], check=True)
        target = Path(self.get_ext_fullpath(extension.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        (module,) = (build / "python" / "constrictions").glob("_constrictions.*")
        shutil.copy2(module, target)


setup(
    version=version,
    ext_modules=[Extension("constrictions._constrictions", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
