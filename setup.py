# SPDX-License-Identifier: GPL-3.0-or-later
"""The module is built by CMake; what it needs of data and configurations goes into the package beside it.

HITOS_BUILD: a folder that CMake has configured with the module already; its target is built there. Else it
is configured in setuptools' own folder, with CMAKE_ARGS.
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent
VERSION = re.search(r"project\(hitos VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]


class BuildByCMake(build_ext):
    def build_extension(self, ext):
        built = os.environ.get("HITOS_BUILD")
        if not built:
            built = pathlib.Path(self.build_temp, "cmake").resolve()
            generator = ["-G", "Ninja"] if shutil.which("ninja") else []
            subprocess.run(["cmake", "-S", ROOT, "-B", built, *generator, "-DCMAKE_BUILD_TYPE=Release",
                            "-DHITOS_GROUPED=ON", "-DHITOS_TESTS=OFF", "-DHITOS_WINDOW=OFF", "-DHITOS_PYTHON=ON",
                            f"-DPython_EXECUTABLE={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", ""))],
                           check=True)
        subprocess.run(["cmake", "--build", built, "--target", "hitos_python", "--parallel", str(os.cpu_count())],
                       check=True)
        module = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        made = pathlib.Path(built, "python", "hitos", module.name)
        if not made.is_file():
            sys.exit(f"{made} is not there: the folder's module is of another Python than {sys.executable}")
        module.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(made, module)
        if shutil.which("strip"):
            subprocess.run(["strip", "--strip-unneeded", module], check=True)
        shutil.copy2(ROOT / "LICENSE", module.parent)
        for folder in ("config", "data"):
            shutil.copytree(ROOT / folder, module.parent / folder, dirs_exist_ok=True)


(ROOT / "build").mkdir(exist_ok=True)
setup(version=VERSION, ext_modules=[Extension("hitos._hitos", [])], cmdclass={"build_ext": BuildByCMake},
      package_data={"hitos": ["*.pyi", "py.typed"]}, options={"egg_info": {"egg_base": "build"}})
