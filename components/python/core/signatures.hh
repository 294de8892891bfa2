#pragma once

#include <pybind11/pybind11.h>

namespace pongsim::python {

/// Rewrites what pybind11 puts above the docstrings of a module's functions and methods, "step(self: Simulation, count:
/// int = 1) -> None", into the form from which Python takes signatures: so `help`, `inspect.signature` and IPython show
/// "step(self, count=1)". Types are in _core.pyi. Call it last.
void giveSignatures(pybind11::module_& module);

}  // namespace pongsim::python
