#include "core/errors.hh"

#include <pybind11/stl.h>

#include <stdexcept>
#include <utility>

#include "pongsim/handles.hh"

namespace pongsim::python {

py::object errorClass(const char* name) { return py::module_::import("pongsim.errors").attr(name); }

void raise(const char* name, const std::string& text) {
  PyErr_SetString(errorClass(name).ptr(), text.c_str());
  throw py::error_already_set();
}

void raiseLoadError(const std::vector<Diagnostic>& found) {
  const py::object type = errorClass("LoadError");
  PyErr_SetObject(type.ptr(), type(py::cast(found)).ptr());
  throw py::error_already_set();
}

void warnOf(const std::vector<Diagnostic>& found) {
  for (const Diagnostic& diagnostic : found) {
    if (diagnostic.severity != Severity::kWarning) continue;
    if (PyErr_WarnEx(errorClass("WorldWarning").ptr(), format(diagnostic).c_str(), 1) != 0)
      throw py::error_already_set();
  }
}

std::string describe(const py::error_already_set& error) {
  return py::module_::import("pongsim.errors").attr("describe")(error.value()).cast<std::string>();
}

void translateErrors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Gone& error) {
      PyErr_SetString(errorClass("Gone").ptr(), error.what());
    } catch (const Error& error) {
      const py::object type = errorClass("LoadError");
      PyErr_SetObject(type.ptr(), type(py::cast(std::vector<Diagnostic>{error.diagnostic()})).ptr());
    }
  });
}

}  // namespace pongsim::python
