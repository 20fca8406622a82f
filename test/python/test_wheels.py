# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The configuration of cibuildwheel names what there is: systems, Pythons, tests, and Eigen by its sum."""

import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
tomllib = pytest.importorskip("tomllib")  # of Python 3.11
SETTINGS = tomllib.loads((ROOT / "examples/python/pyproject.toml").read_text())
WHEELS = SETTINGS["tool"]["cibuildwheel"]


def test_all_systems_have_wheels():
    systems = {name: set(WHEELS[name]["archs"].split()) for name in ("linux", "macos", "windows")}
    assert systems == {"linux": {"x86_64", "aarch64"}, "macos": {"x86_64", "arm64"}, "windows": {"AMD64"}}


def test_wheels_are_for_the_pythons_that_are_supported():
    least = re.fullmatch(r">=3\.(\d+)", SETTINGS["project"]["requires-python"])[1]
    built = [int(minor) for minor in re.findall(r"cp3(\d+)-\*", WHEELS["build"])]
    assert built == list(range(int(least), max(built) + 1)) and max(built) >= sys.version_info.minor


def test_commands_name_files_that_exist():
    commands = [value for table in (WHEELS, *(WHEELS[system] for system in ("linux", "macos", "windows")))
                for value in table.values() if isinstance(value, str)]
    named = {path for command in commands for path in re.findall(r"\{project\}/(\S+)", command)} - {"build/eigen"}
    assert ".ci/install_eigen" in named and len(named) >= 4
    for path in named:
        assert (ROOT / path).exists(), path


def test_another_archive_is_refused(tmp_path):
    (tmp_path / "eigen.tar.gz").write_bytes(b"not Eigen")
    run = subprocess.run([sys.executable, ROOT / ".ci/install_eigen", tmp_path / "there", tmp_path / "eigen.tar.gz"],
                         capture_output=True, text=True)
    assert run.returncode == 1 and "is not Eigen 3.4.0" in run.stderr
    assert not (tmp_path / "there").exists()
