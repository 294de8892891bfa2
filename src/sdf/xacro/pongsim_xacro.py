#!/usr/bin/env python3
"""Expands a xacro file for pongsim, by the installed xacro: pongsim-xacro FILE [ARG:=VALUE]...

Prints the result. What xacro refuses is printed as "FILE<tab>LINE<tab>MESSAGE" instead, and the exit code is 3; it is 4 if
there is no xacro. Packages of $(find PACKAGE) are those of AMENT_PREFIX_PATH, then those in the resource folders.
"""

import os
import pathlib
import re
import sys
import types
import xml.dom.expatbuilder
import xml.dom.minidom
import xml.parsers.expat

REFUSED, NO_XACRO = 3, 4
FOLDERS = ("PONGSIM_RESOURCE_PATH", "SDF_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GZ_SIM_RESOURCE_PATH")


def folders_in(variable):
    return [pathlib.Path(folder) for folder in os.environ.get(variable, "").split(":") if folder]


def resource_folders():
    return [folder for variable in FOLDERS for folder in folders_in(variable)]


def is_package(folder, name):
    manifest = folder / "package.xml"
    if not manifest.is_file():
        return False
    told = re.search(r"<name>\s*([^<\s]+)\s*</name>", manifest.read_text(errors="replace"))
    return (told.group(1) if told else folder.name) == name


def share_of(name):
    """The folder of a package."""
    for prefix in folders_in("AMENT_PREFIX_PATH"):
        if (prefix / "share/ament_index/resource_index/packages" / name).exists() or is_package(prefix / "share" / name, name):
            return str(prefix / "share" / name)
    for folder in resource_folders():
        if is_package(folder / name, name):
            return str(folder / name)
    # of another name than its package, or itself a resource folder
    for folder in resource_folders():
        for candidate in [folder, *sorted(folder.glob("*/"))]:
            if is_package(candidate, name):
                return str(candidate)
    raise LookupError(f"there is no package '{name}' in AMENT_PREFIX_PATH and the resource folders; "
                      "--packages FOLDER names a folder with its sources")


def with_folders(text):
    """Resolves package://NAME of packages whose folders have other names: they are found nowhere else."""
    def resolved(address):
        name = address.group(1)
        try:
            return address.group() if any((each / name).exists() for each in resource_folders()) else f"file://{share_of(name)}/"
        except LookupError:
            return address.group()

    return re.sub(r"package://([^/\s\"']+)/", resolved, text)


class Places:
    """Remembers the file and the line of each element, also of those that macros copy."""

    def __init__(self, xacro):
        self.file = None
        start, clone, parse = xml.dom.expatbuilder.Namespaces.start_element_handler, xml.dom.minidom._clone_node, xacro.parse

        def remember(builder, *arguments):
            start(builder, *arguments)
            builder.curNode.pongsim_place = (self.file, builder.getParser().CurrentLineNumber)

        def keep(node, *arguments):
            copied = clone(node, *arguments)
            if hasattr(node, "pongsim_place"):
                copied.pongsim_place = node.pongsim_place
            return copied

        def parse_in(inp, filename=None):
            self.file = str(filename)
            return parse(inp, filename)

        xml.dom.expatbuilder.Namespaces.start_element_handler = remember
        xml.dom.minidom._clone_node = keep
        xacro.parse = parse_in

    def of(self, error):
        """Where it happened: the innermost element that was being processed."""
        if isinstance(error, xml.parsers.expat.ExpatError):
            return self.file, error.lineno
        place, trace = (self.file, 0), error.__traceback__
        while trace is not None:
            for name in ("elt", "node"):
                element = trace.tb_frame.f_locals.get(name)
                place = getattr(element, "pongsim_place", place)
            trace = trace.tb_next
        return place


def use_own_index():
    """xacro asks ament_index_python, which may be missing, and knows only what is installed."""
    index = types.ModuleType("ament_index_python.packages")
    index.get_package_share_directory = share_of
    index.PackageNotFoundError = LookupError
    sys.modules["ament_index_python"] = types.ModuleType("ament_index_python")
    sys.modules["ament_index_python.packages"] = index


def main(file, *arguments):
    use_own_index()
    try:
        import xacro
    except ImportError:
        return NO_XACRO
    places = Places(xacro)
    mappings = dict(each.split(":=", 1) for each in arguments)
    output, sys.stdout = sys.stdout, sys.stderr
    try:
        text = xacro.process_file(file, mappings=mappings).toprettyxml(indent="  ")
    except (Exception, SystemExit) as error:
        where, line = places.of(error)
        message = re.sub(r"<class '[\w.]+'>: ", "", " ".join(str(error).split())) or repr(error)
        # xacro adds what caused it, which may be the same once more
        half = len(message) // 2
        message = message[:half] if message[:half] == message[half + 1:] else message
        print(where or file, line, message, sep="\t", file=output)
        return REFUSED
    output.write(with_folders(text))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
