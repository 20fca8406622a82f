# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The source distribution has all that building the module reads, and CMake takes it as its pyproject.toml says;
likewise what the recipes for Conan and nix name."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tarfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = os.environ.get("CGP_BUILD_FOLDER")
tomllib = pytest.importorskip("tomllib")  # of Python 3.11


@pytest.fixture(name="sources", scope="module")
def unpacked(tmp_path_factory):
    folder = tmp_path_factory.mktemp("sdist")
    archive = subprocess.run([ROOT / ".ci/make_sdist", folder], check=True, stdout=subprocess.PIPE, text=True).stdout
    with tarfile.open(archive.strip()) as content:
        content.extractall(folder)
    top, = (path for path in folder.iterdir() if path.is_dir())
    return top


def test_the_name_and_the_metadata_are_those_of_the_project(sources):
    project = tomllib.loads((sources / "pyproject.toml").read_text())["project"]
    metadata = (sources / "PKG-INFO").read_text()
    name, version = re.fullmatch(r"(\w+)-([0-9.]+)", sources.name).groups()
    assert name == project["name"].replace("-", "_")
    assert f"Name: {project['name']}\nVersion: {version}\n" in metadata
    assert (sources / project["readme"]).exists() and not list(sources.rglob("__pycache__"))


def read_by_the_module():
    """The files of the checkout that compiling the module and its libraries reads."""
    deps = subprocess.run(["ninja", "-C", BUILD, "-t", "deps"], check=True, stdout=subprocess.PIPE, text=True).stdout
    for block in deps.split("\n\n"):
        target, *files = block.splitlines() or [""]
        if re.search(r"cgp_kernels\.dir|cgp_linear_algebra\.dir|conformal_geometry\.dir", target):
            yield from (pathlib.Path(BUILD, file.strip()).resolve() for file in files)


@pytest.mark.skipif(not BUILD, reason="no build folder")
def test_it_has_all_that_is_compiled(sources):
    build = pathlib.Path(BUILD).resolve()
    wanted = {file.relative_to(ROOT) for file in read_by_the_module()
              if file.is_relative_to(ROOT) and not file.is_relative_to(build)}
    assert len(wanted) > 200
    assert [file for file in wanted if not (sources / file).exists()] == []


def test_cmake_takes_it_without_the_checkout(sources, tmp_path):
    settings = tomllib.loads((sources / "pyproject.toml").read_text())["tool"]["scikit-build"]
    defined = [f"-D{name}={value}" for name, value in settings["cmake"]["define"].items()]
    subprocess.run(["cmake", "-S", sources / settings["cmake"]["source-dir"], "-B", tmp_path, *defined], check=True,
                   stdout=subprocess.DEVNULL)
    targets = subprocess.run(["cmake", "--build", tmp_path, "--target", "help"], check=True, stdout=subprocess.PIPE,
                             text=True).stdout
    assert "conformal_geometry" in targets and str(ROOT) not in (tmp_path / "CMakeCache.txt").read_text()


def test_cmake_takes_what_the_recipe_for_conan_exports(tmp_path):
    recipe = (ROOT / ".cmake/conanfile.py").read_text()
    patterns = re.search(r"for pattern in \(([^)]*)\)", recipe)[1]
    for path in re.findall(r'"([^"*]+?)(?:/\*)?"', patterns):
        copy = shutil.copytree if (ROOT / path).is_dir() else shutil.copy
        (tmp_path / "sources" / path).parent.mkdir(parents=True, exist_ok=True)
        copy(ROOT / path, tmp_path / "sources" / path)
    parts = re.findall(r'"([A-Z]+)"', recipe)
    assert len(parts) == 4
    subprocess.run(["cmake", "-S", tmp_path / "sources", "-B", tmp_path / "build",
                    *(f"-DCGP_BUILD_{part}=OFF" for part in parts)], check=True, stdout=subprocess.DEVNULL)


# What a recipe for nix is called with, in place of nixpkgs.
NIXPKGS = """let names = [ "cmake" "cgal" "eigen" "boost" "gmp" "mpfr" ];
in import %s ({ lib = { cleanSource = toString; licenses.lgpl3Plus = "LGPL-3.0-or-later"; };
  stdenv.mkDerivation = given: given; } // builtins.listToAttrs (map (name: { inherit name; value = name; }) names))"""


@pytest.mark.skipif(not shutil.which("nix-instantiate"), reason="Debian: apt-get install nix-bin")
def test_cmake_takes_what_the_recipe_for_nix_says(tmp_path):
    run = subprocess.run(["nix-instantiate", "--store", "dummy://", "--eval", "--strict", "--json", "--expr",
                          NIXPKGS % (ROOT / ".cmake/package.nix")], check=True, stdout=subprocess.PIPE, text=True,
                         env={**os.environ, "HOME": str(tmp_path)})
    recipe = json.loads(run.stdout)
    assert pathlib.Path(recipe["src"]) == ROOT
    told = subprocess.run(["cmake", "-S", ROOT, "-B", tmp_path / "build", *recipe["cmakeFlags"]], check=True,
                          capture_output=True, text=True)
    assert "not used" not in told.stderr, told.stderr
