#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>

#include "core/errors.hh"
#include "core/handles.hh"
#include "core/interpreter.hh"
#include "core/monitor.hh"
#include "core/picture.hh"
#include "core/pool.hh"
#include "core/python_system.hh"
#include "core/sensor.hh"
#include "core/signatures.hh"
#include "core/simulation.hh"
#include "core/topics.hh"
#include "pongsim/files/resolved_sdf.hh"
#include "pongsim/log.hh"

namespace {

/// Fortress's numbers.
void setLogLevel(int level) {
  if (level < 0 || level > 4) throw pybind11::value_error("a log level must be 0 (nothing) to 4 (debug)");
  pongsim::setLogLevel(static_cast<pongsim::LogLevel>(level));
}

/// Raises LoadError.
std::string sdfOf(const std::string& file) {
  pongsim::Diagnostics diagnostics;
  std::optional<std::string> text;
  {
    const pongsim::python::interpreter::Released released;
    text = pongsim::resolvedSdf(file, diagnostics);
  }
  if (!text) pongsim::python::raiseLoadError(diagnostics.all());
  return *std::move(text);
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  namespace python = pongsim::python;
  python::interpreter::expectEnd();
  python::translateErrors();
  python::bindSensors(module);
  python::bindHandles(module);
  python::bindTopics(module);
  python::bindSystems(module);
  python::bindSimulation(module);
  python::bindPool(module);
  python::bindPictures(module);
  python::bindMonitor(module);
  module.attr("version") = PONGSIM_VERSION;
  module.def("set_log_level", &setLogLevel, pybind11::arg("level"),
             "Sets how much the process says on stderr: 0 nothing, 1 errors, 2 warnings (the default), 3 more, 4 all.");
  module.def("resolved_sdf", &sdfOf, pybind11::arg("file"),
             "Returns an SDF or URDF file as one SDF text. Raises LoadError.");
  python::giveSignatures(module);
}
