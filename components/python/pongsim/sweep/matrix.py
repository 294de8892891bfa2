"""Reads what sweeps and scenarios of tests have in common: a world, its parameters and seeds."""

from __future__ import annotations

import os
import pathlib
from typing import Any, Mapping

from .. import worlds
from . import design, template, world
from .document import Node
from .errors import nearest
from .plan import Run, Target


class MatrixReader:
    """Reads `world`, `parameters`, `combine`, `latin_hypercube` and `seeds` of a file."""

    #: Names that parameters can't have.
    reserved: tuple[str, ...] = ("seed",)

    def __init__(self, root: Node, parts: Mapping[str, Node], folder: pathlib.Path) -> None:
        self.root = root
        self.parts = parts
        #: Where its files are.
        self.folder = folder
        #: The parameters.
        self.names: list[str] = []

    def runs(self) -> tuple[list[Run], list[world.TargetPath]]:
        """Returns all runs, and where their parameters go in the world."""
        axes: list[design.Axis] = []
        target_paths: list[world.TargetPath] = []
        parameters = self.parts["parameters"].mapping("parameters") if "parameters" in self.parts else {}
        self.names = list(parameters)
        for name, node in parameters.items():
            if not name.isidentifier() or name in self.reserved:
                node.fail(f"'{name}' can't be the name of a parameter", "use letters, digits and _, and not " + ", ".join(self.reserved))
            node.mapping(f"parameter '{name}'", ["values", "range", "between", "xpath", "text"])
            axes.append(design.read_axis(name, node))
            target_paths += self._target_paths(name, node)
        combine = self.parts["combine"].text("combine") if "combine" in self.parts else "grid"
        if combine not in ("grid", "zip"):
            self.parts["combine"].fail(f"combine must be grid or zip, not '{combine}'")
        samples, seed = self._sampling(axes)
        runs = design.make_runs(axes, combine, samples, seed, design.read_seeds(self.parts.get("seeds")), self.root)
        return runs, target_paths

    def _sampling(self, axes: list[design.Axis]) -> tuple[int, int]:
        drawn = [axis for axis in axes if axis.between is not None]
        node = self.parts.get("latin_hypercube")
        if node is None:
            if drawn:
                drawn[0].at.fail(f"'{drawn[0].name}' has 'between', but there is no 'latin_hypercube'",
                                 "write latin_hypercube: {samples: 100, seed: 1}")
            return 0, 0
        parts = node.mapping("latin_hypercube", ["samples", "seed"])
        if not drawn:
            node.fail("latin_hypercube needs a parameter with 'between'")
        if "samples" not in parts:
            node.fail("latin_hypercube has no 'samples'")
        samples = parts["samples"].whole("samples", least=1, most=design.MOST_RUNS)
        return samples, parts["seed"].whole("the seed of latin_hypercube") if "seed" in parts else 0

    def _target_paths(self, name: str, node: Node) -> list[world.TargetPath]:
        parts = node.mapping("a parameter")
        text = parts["text"].text("text") if "text" in parts else None
        if "xpath" not in parts:
            if text is not None:
                parts["text"].fail("'text' needs an 'xpath'")
            return []
        if text is not None:
            self.check_names(text, parts["text"])
        paths = parts["xpath"].list("xpath") if isinstance(parts["xpath"].value, list) else [parts["xpath"]]
        return [world.TargetPath(name, path.text("xpath"), text, path.at) for path in paths]

    def check_names(self, text: Any, node: Node) -> None:
        """Checks that all $NAMEs in a text or message are parameters."""
        for name in template.names(text, node.at):
            if name not in self.names:
                node.fail(f"${name} is not a parameter", nearest(name, self.names) or "write $$ for a $")

    def read_world(self, target_paths: list[world.TargetPath]) -> tuple[str, str | None, tuple[Target, ...]]:
        """Returns the world's file, which is beside this one or where `pongsim run` finds it; with parameters also its
        text, and their places in it."""
        node = self.parts["world"]
        name = node.text("world")
        path = str(self.folder / name)
        if not os.path.isfile(path):
            found = worlds.find(name)
            if found == name:
                beside = [each for each in os.listdir(self.folder) if each.endswith(".sdf")] if self.folder.is_dir() else []
                close = nearest(name, [*beside, *worlds.names()])
                node.fail(f"there is no file {path}", close if close.startswith("did") else "")
            path = found
        text = world.read(path, node.at) if target_paths else None
        return path, text, world.find(text, path, target_paths) if text is not None else ()
