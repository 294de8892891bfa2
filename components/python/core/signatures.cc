#include "core/signatures.hh"

#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "core/arguments.hh"
#include "core/parameters.hh"

namespace pongsim::python {

namespace py = pybind11;

namespace {

/// @return The docstring in Python's form; empty if pybind11 has not made it, for several overloads, and for parameters
/// without names.
std::string rewritten(const std::string& name, std::string_view doc) {
  const auto parameters = parametersOf(name, doc);
  if (!parameters) return {};
  std::string result = name + "(";
  bool isFirst = true;
  for (const Parameter& parameter : *parameters) {
    // pybind11's name for one without a name: a function for the package itself
    if (parameter.name.starts_with("arg0")) return {};
    result += (isFirst ? "" : ", ") + parameter.name + (parameter.value ? "=" + *parameter.value : "");
    isFirst = false;
  }
  const std::size_t line = doc.find('\n');
  std::string_view text = line == std::string_view::npos ? std::string_view() : doc.substr(line);
  while (text.starts_with('\n')) text.remove_prefix(1);
  while (text.ends_with('\n')) text.remove_suffix(1);
  return result + ")\n--\n\n" + std::string(text);
}

void giveSignature(py::handle function) {
  if (PyInstanceMethod_Check(function.ptr())) function = PyInstanceMethod_GET_FUNCTION(function.ptr());
  if (!PyCFunction_Check(function.ptr())) return;
  PyMethodDef* method = reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
  if (method->ml_doc == nullptr) return;
  tellOfArguments(function, method->ml_name);
  const std::string doc = rewritten(method->ml_name, method->ml_doc);
  if (doc.empty()) return;
  // pybind11 allocates and frees it so
  std::free(const_cast<char*>(method->ml_doc));
  method->ml_doc = strdup(doc.c_str());
}

}  // namespace

void giveSignatures(py::module_& module) {
  for (const auto& [name, thing] : py::dict(module.attr("__dict__"))) {
    giveSignature(thing);
    if (!PyType_Check(thing.ptr())) continue;
    for (const auto& [part, member] : py::dict(thing.attr("__dict__"))) {
      giveSignature(member);
      if (!PyObject_TypeCheck(member.ptr(), &PyProperty_Type)) continue;
      const py::object setter = member.attr("fset");
      if (!setter.is_none()) tellOfArguments(setter, py::cast<std::string>(part));
    }
  }
}

}  // namespace pongsim::python
