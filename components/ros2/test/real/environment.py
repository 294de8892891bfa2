#!/usr/bin/env python3
"""The real ROS 2 for tests: virtual environments with rclpy and its middleware from PyPI, with interfaces built for it, and
with ROS's command line and tf2 from their repositories.

    environment.py make DISTRO FOLDER      makes it, once per user, and links it to FOLDER
    environment.py run DISTRO FOLDER ARG...   runs its Python; returns 77 (skipped) where PyPI could not be reached

Where the repositories can't be reached, FOLDER/no_tools says why. Git's own `url.BASE.insteadOf` gives other places for them.
"""

import fcntl
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
CACHE = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "pongsim-tests"
SKIPPED = 77
NO_GIT = re.compile("unable to access|Could not resolve|does not appear to be a git repository")
UNREACHABLE = re.compile("NewConnectionError|ConnectTimeoutError|ReadTimeoutError|ProxyError|NameResolutionError")


class Unreachable(Exception):
    pass


def requirements(distro):
    return HERE / distro / "requirements.txt"


def sources(distro):
    """Packages that are not on PyPI: a line for each repository, with its commit and the packages' folders."""
    return HERE / distro / "sources.txt"


def interfaces(distro):
    """Those of all, then those that differ in this one."""
    return [each for each in (HERE / "interfaces.txt", HERE / distro / "interfaces.txt") if each.exists()]


def place(distro):
    """The environment's folder: another one for other packages, interfaces or another Python."""
    inputs = [requirements(distro), sources(distro), *interfaces(distro), pathlib.Path(__file__)]
    key = hashlib.sha256(b"".join(each.read_bytes() for each in inputs) + sys.version.encode()).hexdigest()
    return CACHE / f"ros2-{distro}-{key[:16]}"


def install(distro, venv):
    subprocess.run([sys.executable, "-m", "venv", venv], check=True)
    # empy is published as source alone; what builds it is among the packages and comes first
    text = requirements(distro).read_text()
    first = venv / "setuptools.txt"
    first.write_text(re.search(r"^setuptools==(?:.*\\\n)*.*\n", text, re.M).group())
    for file in (first, requirements(distro)):
        pip = [venv / "bin/pip", "install", "--quiet", "--disable-pip-version-check", "--require-hashes", "--no-deps",
               "--only-binary", ":all:", "--no-binary", "empy", "--no-build-isolation", "--requirement", file]
        result = subprocess.run(pip, capture_output=True, text=True)
        if result.returncode != 0:
            reason = result.stderr.strip()
            raise (Unreachable if UNREACHABLE.search(reason) else RuntimeError)(reason[-2000:])


def move(venv):
    """The CMake files name the Python that the packages were built with: put this one's in its place."""
    built = r"/opt/python/cp3\d+-cp3\d+"
    packages = venv / f"lib/python{sysconfig.get_python_version()}/site-packages"
    for file in (venv / "share").rglob("*.cmake"):
        text = file.read_text()
        moved = re.sub(built + r"/lib/python3\.\d+/site-packages", str(packages), text)
        moved = re.sub(built + r"/include/python3\.\d+", sysconfig.get_path("include"), moved)
        if moved != text:
            file.write_text(moved)


def packages(distro):
    """The interfaces: for each package the text of each file."""
    found = {}
    for file in interfaces(distro):
        for block in file.read_text().split("=== ")[1:]:
            name, _, text = block.partition("\n")
            package, kind, interface = name.split("/")
            found.setdefault(package, {})[f"{kind}/{interface}.{kind}"] = text
    return found


def build(name, files, venv, folder):
    """Generates and installs an interface package, as colcon does."""
    needs = sorted({package for text in files.values() for package in re.findall(r"^(\w+)/\w+", text, re.M)})
    for file, text in files.items():
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_text(text)
    (folder / "package.xml").write_text(
        f'<package format="3"><name>{name}</name><version>0.0.0</version><description>for tests</description>'
        '<maintainer email="nobody@example.com">nobody</maintainer><license>Apache-2.0</license>'
        "<buildtool_depend>ament_cmake</buildtool_depend><buildtool_depend>rosidl_default_generators</buildtool_depend>"
        + "".join(f"<depend>{each}</depend>" for each in needs)
        + "<member_of_group>rosidl_interface_packages</member_of_group></package>")
    (folder / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.20)\nproject({name} C CXX)\nset(CMAKE_CXX_STANDARD 17)\n"
        + "".join(f"find_package({each} REQUIRED)\n" for each in ["ament_cmake", "rosidl_default_generators", *needs])
        + f"rosidl_generate_interfaces({name} {' '.join(sorted(files))} DEPENDENCIES {' '.join(needs)})\nament_package()\n")
    compile_and_install(folder, venv)


def compile_and_install(folder, venv):
    environment = {**os.environ, "CMAKE_PREFIX_PATH": str(venv), "AMENT_PREFIX_PATH": str(venv),
                   "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1", "PATH": f"{venv}/bin:{os.environ['PATH']}"}
    for command in (["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", f"-DCMAKE_INSTALL_PREFIX={venv}",
                     f"-DPython3_EXECUTABLE={venv}/bin/python", "-DBUILD_TESTING=OFF", "-DCMAKE_CXX_FLAGS=-O0 -w",
                     "-DCMAKE_C_FLAGS=-O0 -w", f"-DCMAKE_INSTALL_RPATH={venv}/lib"],
                    ["ninja", "-C", folder / "build", "install"]):
        result = subprocess.run(command, env=environment, capture_output=True, text=True)
        if result.returncode != 0:
            raise RuntimeError(f"can't build {folder.name}: {(result.stdout + result.stderr)[-3000:]}")


def run(*command):
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode != 0:
        reason = result.stderr.strip()[-2000:]
        raise (Unreachable if NO_GIT.search(reason) else RuntimeError)(reason)


def install_tools(distro, venv):
    """Installs what is in `sources`, once it can be had."""
    done, why_not = venv / "tools_complete", venv / "no_tools"
    if done.exists():
        return
    with tempfile.TemporaryDirectory() as place:
        try:
            for number, line in enumerate(sources(distro).read_text().splitlines()):
                address, commit, *folders = line.split()
                source = pathlib.Path(place) / str(number)
                run("git", "init", "--quiet", source)
                run("git", "-C", source, "fetch", "--quiet", "--depth", "1", address, commit)
                run("git", "-C", source, "checkout", "--quiet", "FETCH_HEAD")
                for each in folders:
                    if (source / each / "setup.py").exists():
                        run(venv / "bin/pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps",
                            "--no-build-isolation", source / each)
                    elif (source / each / "CMakeLists.txt").exists():
                        compile_and_install(source / each, venv)
                    else:
                        # a package beside C++ code, which is not needed
                        packages = venv / f"lib/python{sysconfig.get_python_version()}/site-packages"
                        shutil.copytree(source / each, packages / pathlib.Path(each).name, dirs_exist_ok=True)
        except Unreachable as why:
            why_not.write_text(str(why))
            return
    why_not.unlink(missing_ok=True)
    done.touch()


def make(distro, folder):
    CACHE.mkdir(parents=True, exist_ok=True)
    venv = place(distro)
    with open(CACHE / f"ros2-{distro}.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (venv / "complete").exists():
            # of earlier requirements, or begun
            for old in CACHE.glob(f"ros2-{distro}-*"):
                shutil.rmtree(old)
            install(distro, venv)
            move(venv)
            for name, files in packages(distro).items():
                build(name, files, venv, venv / "interfaces" / name)
            shutil.rmtree(venv / "interfaces")
            (venv / "complete").touch()
        install_tools(distro, venv)
    folder.unlink(missing_ok=True)
    folder.symlink_to(venv)


def main(action, distro, folder, *arguments):
    folder = pathlib.Path(folder)
    reason = folder.with_name(folder.name + ".unreachable")
    if action == "make":
        reason.unlink(missing_ok=True)
        try:
            make(distro, folder)
        except Unreachable as why:
            reason.write_text(str(why))
            print(f"the tests with the real ROS 2 are skipped, for PyPI can't be reached: {why}")
        return 0
    if reason.exists():
        print(f"skipped, for PyPI can't be reached: {reason.read_text()}")
        return SKIPPED
    environment = {**os.environ, "AMENT_PREFIX_PATH": str(folder.resolve())}
    return subprocess.run([folder / "bin/python", *arguments], env=environment).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
