# SPDX-License-Identifier: MIT
#
# A Conan 2 recipe of this source tree: conan create cmake/packaging/conan
import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, get, load

required_conan_version = ">=2.0"


class TypemeshConan(ConanFile):
    name = "typemesh"
    description = "Header-only C++20 library that makes meshes of text: flat, extruded or bevelled, for any vertex layout"
    license = "MIT", "Unicode-3.0"
    topics = ("text", "mesh", "fonts", "triangulation", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {name: [True, False] for name in ("harfbuzz", "freetype", "fontconfig", "icu", "glm")}
    default_options = {"harfbuzz": True, "freetype": False, "fontconfig": False, "icu": False, "glm": False}
    no_copy_source = True

    # Each adapter: its package, and the target of it that users link.
    adapters = {
        "harfbuzz": ("harfbuzz/[>=4]", "harfbuzz::harfbuzz"),
        "freetype": ("freetype/[>=2.10]", "freetype::freetype"),
        "fontconfig": ("fontconfig/[>=2.13]", "fontconfig::fontconfig"),
        "icu": ("icu/[>=70]", "icu::icu-uc"),
        "glm": ("glm/[>=0.9.9]", "glm::glm"),
    }

    @property
    def _root(self):
        return os.path.join(self.recipe_folder, "..", "..", "..")

    # A registry has the sources of a version in conandata.yml, and the tree is not around its recipe.
    def set_version(self):
        if self.version:
            return
        header = load(self, os.path.join(self._root, "include", "typemesh", "core", "version.hpp"))
        parts = (re.search(f"TYPEMESH_VERSION_{part} ([0-9]+)", header) for part in ("MAJOR", "MINOR", "PATCH"))
        self.version = ".".join(part.group(1) for part in parts)

    def export_sources(self):
        if self.conan_data:
            return
        copy(self, "LICENSE", self._root, self.export_sources_folder)
        copy(self, "include/*", self._root, self.export_sources_folder)

    def source(self):
        if self.conan_data:
            get(self, **self.conan_data["sources"][self.version], strip_root=True)

    def requirements(self):
        for name, (package, _) in self.adapters.items():
            if self.options.get_safe(name):
                self.requires(package, transitive_headers=True)

    def validate(self):
        check_min_cppstd(self, 20)

    def package_id(self):
        self.info.clear()

    def package(self):
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))
        for pattern in ("*.hpp", "typemesh/compiled/*.cpp"):
            copy(self, pattern, os.path.join(self.source_folder, "include"), os.path.join(self.package_folder, "include"))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "typemesh")
        core = self.cpp_info.components["core"]
        core.set_property("cmake_target_name", "typemesh::typemesh")
        core.set_property("pkg_config_name", "typemesh")
        core.bindirs, core.libdirs = [], []
        for name, (_, target) in self.adapters.items():
            if self.options.get_safe(name):
                adapter = self.cpp_info.components[name]
                adapter.set_property("cmake_target_name", f"typemesh::{name}")
                adapter.set_property("pkg_config_name", f"typemesh-{name}")
                adapter.requires = ["core", target]
                adapter.bindirs, adapter.libdirs = [], []
