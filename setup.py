# SPDX-FileCopyrightText: 2026 The pcm authors
# SPDX-License-Identifier: BSD-3-Clause
"""Has CMake build the Python module where setuptools wants it. CMAKE_ARGS, where set, goes to CMake."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        folder = Path(self.get_ext_fullpath(extension.name)).resolve().parent
        build = Path(self.build_temp).resolve()
        options = ["-DCMAKE_BUILD_TYPE=Release", "-DPCM_BUILD_ENGINE_ONLY=ON", "-DPCM_BUILD_TESTS=OFF",
                   "-DPCM_INSTALL=OFF", "-DPCM_SIMBODY=OFF", "-DPCM_PYTHON_REQUIRED=ON",
                   f"-DPython_EXECUTABLE={sys.executable}", f"-DCMAKE_LIBRARY_OUTPUT_DIRECTORY={folder}",
                   *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *generator, *options], check=True)
        # Make, told no number, would compile all files at once.
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", build, "--target", "pcm_python", "--parallel", jobs], check=True)


def version():
    return re.search(r"^project\(pcm VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)[1]


# What setuptools writes down on the way stays out of the checkout.
(ROOT / "build").mkdir(exist_ok=True)
setup(
    version=version(),
    ext_modules=[Extension("pcm", sources=[])],
    packages=[],
    py_modules=[],
    cmdclass={"build_ext": BuildByCMake},
    options={"egg_info": {"egg_base": "build"}},
)
