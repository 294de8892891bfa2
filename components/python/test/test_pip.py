"""The metadata for `pip` fits the package. tools/fresh-check --wheel tests that a wheel works."""

import ast
import importlib
import os
import pathlib
import re
import subprocess
import sys

import pytest
from conftest import PROJECT

import pongsim

tomllib = pytest.importorskip("tomllib", reason="Python 3.11 reads it")
PYPROJECT = tomllib.loads((PROJECT / "pyproject.toml").read_text())
SOURCES = PROJECT / "components/python/pongsim"
#: Names of modules that differ from PyPI's.
NAMES = {"yaml": "PyYAML", "google": "protobuf", "stable_baselines3": "stable-baselines3"}


def test_the_version_is_that_of_the_build():
    settings = PYPROJECT["tool"]["scikit-build"]["metadata"]["version"]
    found = re.search(settings["regex"], (PROJECT / settings["input"]).read_text())
    assert found["value"] == pongsim.__version__


def test_what_is_started_is_there():
    module, function = PYPROJECT["project"]["scripts"]["pongsim"].split(":")
    assert callable(getattr(importlib.import_module(module), function))


def needed():
    """The third-party packages that the modules import."""
    names = set()
    for file in SOURCES.rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.Import):
                names |= {each.name.partition(".")[0] for each in node.names}
            elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
                names.add(node.module.partition(".")[0])
            elif isinstance(node, ast.Call) and getattr(node.func, "id", getattr(node.func, "attr", "")) in ("need", "import_module"):
                if isinstance(node.args[0], ast.Constant):
                    names.add(node.args[0].value.partition(".")[0])
    return {NAMES.get(name, name) for name in names - sys.stdlib_module_names - {"pongsim"}}


def test_what_the_package_imports_it_asks_for():
    project = PYPROJECT["project"]
    asked = [*project["dependencies"], *(each for group in project["optional-dependencies"].values() for each in group)]
    assert needed() <= {re.match(r"[A-Za-z0-9_-]+", each)[0] for each in asked}


def test_an_editable_installation_uses_the_files_of_the_source_tree():
    """pip takes the modules from there, and CMake does not install copies beside them."""
    assert PYPROJECT["tool"]["scikit-build"]["wheel"]["packages"] == [str(SOURCES.relative_to(PROJECT))]
    assert "if(NOT SKBUILD)\n  install(DIRECTORY pongsim/" in (SOURCES.parent / "CMakeLists.txt").read_text()


def test_the_folder_is_that_of_an_installation(tmp_path, program):
    """The build has installed everything where a wheel's program and library look for it."""
    settings = PYPROJECT["tool"]["scikit-build"]
    assert settings["wheel"]["install-dir"] == "pongsim"
    assert settings["cmake"]["define"]["PONGSIM_PYTHON_PACKAGE_FOLDER"] == "."
    package = tmp_path / "pongsim"
    build = pathlib.Path(program).parents[1]
    package.mkdir()
    for name in ("bin", "lib", "libexec", "share"):
        (package / name).symlink_to(build / name)
    (package / "program.py").write_text((SOURCES / "program.py").read_text())
    code = "import runpy, sys; sys.argv = ['pongsim', '--version']; runpy.run_path('pongsim/program.py')['main']()"
    result = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, env=dict(os.environ))
    assert result.stdout.startswith(f"pongsim {pongsim.__version__}"), result
    (package / "bin").unlink()
    result = subprocess.run([sys.executable, "-c", code.replace("runpy.run", "print(runpy.run").replace("()", "())")],
                            cwd=tmp_path, capture_output=True, text=True)
    assert result.stdout == "1\n" and "is not a wheel" in result.stderr


def test_a_build_names_all_packages_that_are_missing_at_once(tmp_path):
    """Here pkg-config finds nothing, and Embree is not there."""
    done = subprocess.run(
        ["cmake", "-S", PROJECT, "-B", tmp_path, "-DCMAKE_DISABLE_FIND_PACKAGE_embree=ON", "-DBUILD_TESTING=OFF"],
        capture_output=True, text=True, env={**os.environ, "PKG_CONFIG_LIBDIR": "/nonexistent"},
    )
    text = " ".join(done.stderr.split())
    assert done.returncode != 0
    named = text.partition("sudo apt-get install ")[2].partition(" Call Stack")[0].split()
    assert {"libembree-dev", "libbullet-dev", "libassimp-dev", "libignition-msgs-dev"} <= set(named), text
    known = re.findall(r"^ ([a-z0-9.+-]+)", (PROJECT / "debian/control").read_text().partition("Build-Depends:")[2].partition("\n\n")[0], re.M)
    assert set(named) <= set(known)
