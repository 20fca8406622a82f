# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""A recipe for Conan 2, run from the checkout: conan create .cmake"""

import pathlib

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain
from conan.tools.files import copy


class ConformalGeometryProcessing(ConanFile):
    name = "conformal-geometry-processing"
    version = "1.0.0"
    license = "LGPL-3.0-or-later"
    description = "Surfaces edited, smoothed and flattened by their curvature, without shear"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False]}
    default_options = {"shared": True}
    requires = "cgal/[>=5.5 <7]", "eigen/[>=3.4 <6]"

    def export_sources(self):
        top = pathlib.Path(self.recipe_folder).parent
        for pattern in ("CMakeLists.txt", ".cmake/*", "include/*", "doc/licenses/*"):
            copy(self, pattern, top, self.export_sources_folder)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for part in ("TESTS", "EXAMPLES", "BENCHMARKS", "DOC"):
            toolchain.variables[f"CGP_BUILD_{part}"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        # Users read the targets that we install ourselves.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/Conformal_geometry_processing"]
