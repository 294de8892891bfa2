"""Loads the system and answers pongsim's calls."""

import importlib.abc
import importlib.machinery
import importlib.util
import os
import re
import signal
import sys
import traceback
import xml.etree.ElementTree as ElementTree

HELP = (
    "pongsim has Model, Link, Joint, World and world_entity of gz.sim, Vector3d, Quaterniond and Pose3d of gz.math, and "
    "sdformat's Element"
)

HOOKS = ("configure", "pre_update", "update", "post_update", "reset")

MODULES = {
    "gz.math": (Vector3d, Quaterniond, Pose3d),
    "gz.sim": (World, Model, Link, Joint, EntityComponentManager, EventManager, UpdateInfo),
    "sdformat": (Element,),
}


class GazeboModules(importlib.abc.MetaPathFinder, importlib.abc.Loader):
    """Gazebo's modules, by any release's name: gz.sim, gz.sim8."""

    def find_spec(self, name, path=None, target=None):
        if name == "gz" or name.startswith("gz.") or re.fullmatch(r"sdformat\d*", name):
            return importlib.machinery.ModuleSpec(name, self, is_package=name == "gz")
        return None

    def create_module(self, spec):
        return None

    def exec_module(self, module):
        name = module.__name__
        if name == "gz":
            return
        known = re.sub(r"\d+$", "", name)
        if known not in MODULES:
            raise ImportError(f"{name} is not here: {HELP}")
        for each in MODULES[known]:
            setattr(module, each.__name__, each)
        if known == "gz.sim":
            module.K_NULL_ENTITY = 0
            module.world_entity = lambda *ecm: int(line.ask("world.entity", 0)[0])

        def missing(what):
            if what.startswith("__"):
                raise AttributeError(what)
            raise AttributeError(f"{name}.{what} is not here: {HELP}")

        module.__getattr__ = missing


def load(name, folders):
    """Only from these folders, so that no world runs what else is installed."""
    spec = importlib.machinery.PathFinder.find_spec(name, folders)
    if spec is None or spec.loader is None:
        places = ", ".join(folders) or "none"
        raise ImportError(f"there is no module '{name}' in the folders of systems and in PYTHONPATH: {places}")
    sys.path[:0] = folders
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def place_of(error):
    """Where the module raised it; this program's own lines tell nobody anything."""
    places = [each for each in traceback.extract_tb(error.__traceback__) if os.path.isfile(each.filename)]
    return f" ({places[-1].filename}:{places[-1].lineno})" if places else ""


def call(system, word, words, ecm):
    if word == "configure":
        system.configure(int(words[0]), Element(ElementTree.fromstring(words[1])), ecm, EventManager())
    else:
        getattr(system, word)(UpdateInfo(words), ecm)


def main():
    global line
    line = Line(int(sys.argv[1]))
    # pongsim ends the run, and then this
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    sys.meta_path.insert(0, GazeboModules())
    ecm = EntityComponentManager()
    system = None
    while (words := line.read()) is not None:
        try:
            if words[0] == "load":
                system = load(words[1], words[2:]).get_system()
                line.write("done", *(hook for hook in HOOKS if hasattr(system, hook)))
            else:
                call(system, words[0], words[1:], ecm)
                line.write("done")
        except SystemExit:
            raise
        except BaseException as error:
            sys.stderr.write("".join(traceback.format_exception(type(error), error, error.__traceback__)))
            line.write("failed", f"{type(error).__name__}: {error}{place_of(error)}")
        sys.stdout.flush()
        sys.stderr.flush()
    if hasattr(system, "shutdown"):
        system.shutdown()


main()
