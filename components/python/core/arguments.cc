#include "core/arguments.hh"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/parameters.hh"
#include "pongsim/program/nearest_word.hh"

namespace pongsim::python {

namespace py = pybind11;

namespace {

/// What a function takes.
struct Taken {
  std::string name;
  std::vector<Parameter> parameters;
  /// How many of them may go without names.
  std::size_t positional = 0;
};

/// By what pybind11 hands to all its functions: the function's record.
std::unordered_map<PyObject*, Taken>& taken() {
  // lives as long as the functions: to the end
  static auto* const functions = new std::unordered_map<PyObject*, Taken>();
  return *functions;
}

/// pybind11's own, the same for all its functions.
PyCFunctionWithKeywords dispatcher = nullptr;

struct Fit {
  /// "an integer"; empty where any object may do.
  std::string words;
  bool fits = true;
};

/// @param type As pybind11 writes it: "int", "Optional[float]".
Fit fitOf(std::string_view type, py::handle argument) {
  constexpr std::string_view kOptional = "Optional[";
  if (type.starts_with(kOptional)) {
    const Fit fit = fitOf(type.substr(kOptional.size(), type.size() - kOptional.size() - 1), argument);
    return {fit.words.empty() ? "" : fit.words + " or None", fit.fits || argument.is_none()};
  }
  PyObject* const object = argument.ptr();
  if (type == "int") return {"an integer", PyFloat_Check(object) == 0 && PyIndex_Check(object) != 0};
  if (type == "float") {
    return {"a number", PyFloat_Check(object) != 0 || (PyNumber_Check(object) != 0 && PyComplex_Check(object) == 0)};
  }
  if (type == "str") return {"a text", PyUnicode_Check(object) != 0 || PyBytes_Check(object) != 0};
  if (type == "bytes") return {"bytes", PyBytes_Check(object) != 0};
  if (type == "bool") return {"True or False", PyBool_Check(object) != 0};
  return {};
}

std::string typeName(py::handle object) {
  return object.is_none() ? "None" : std::string(py::str(py::type::of(object).attr("__name__")));
}

/// @return What is wrong with an argument; empty if it is another one.
std::string wrongWith(const Parameter& parameter, py::handle argument) {
  const Fit fit = fitOf(parameter.type, argument);
  if (fit.words.empty()) return {};
  if (!fit.fits) return parameter.name + " must be " + fit.words + ", not " + typeName(argument);
  if (PyLong_Check(argument.ptr()) == 0 || parameter.type == "bool") return {};
  // one of another type is not looked at: what does not fit is the number
  return PyLong_AsLongLong(argument.ptr()) == -1 && PyErr_Occurred() != nullptr
             ? (PyErr_Clear(), parameter.name + " is too large a number")
             : std::string();
}

std::string countedWords(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

/// @param given Those without names; the object first, whose method it is.
std::string mistakeIn(const Taken& function, const py::tuple& given, const py::dict& named) {
  const auto& parameters = function.parameters;
  const bool isMethod = !parameters.empty() && parameters.front().name == "self";
  if (given.size() > function.positional) {
    return function.name + "() takes " + countedWords(function.positional - isMethod) +
           (function.positional < parameters.size() ? " without names" : "") + ", not " +
           std::to_string(given.size() - isMethod);
  }
  std::vector<std::string_view> known;
  for (const Parameter& parameter : parameters) known.push_back(parameter.name);
  for (const auto& [key, value] : named) {
    const auto name = py::cast<std::string>(key);
    if (std::ranges::find(known, name) != known.end()) continue;
    const std::string hint = didYouMean(name, known);
    return function.name + "() has no argument '" + name + "'" + (hint.empty() ? "" : "; " + hint);
  }
  for (std::size_t i = isMethod; i < parameters.size(); ++i) {
    const Parameter& parameter = parameters[i];
    const bool isNamed = named.contains(parameter.name);
    if (i >= given.size() && !isNamed) {
      if (!parameter.value && parameter.name != "*")
        return function.name + "() needs an argument '" + parameter.name + "'";
      continue;
    }
    if (i < given.size() && isNamed) return function.name + "() has '" + parameter.name + "' twice";
    const py::object argument = isNamed ? py::object(named[parameter.name.c_str()]) : py::object(given[i]);
    if (std::string mistake = wrongWith(parameter, argument); !mistake.empty()) return mistake;
  }
  return {};
}

/// Calls the function, and puts what is wrong in words.
PyObject* callInWords(PyObject* record, PyObject* given, PyObject* named) {
  PyObject* const result = dispatcher(record, given, named);
  if (result != nullptr || PyErr_ExceptionMatches(PyExc_TypeError) == 0) return result;
  py::error_already_set error;
  const std::string said = py::str(error.value());
  const auto function = taken().find(record);
  std::string mistake;
  if (said.find("): incompatible function arguments.") != std::string::npos && function != taken().end()) {
    mistake = mistakeIn(function->second, py::reinterpret_borrow<py::tuple>(given),
                        named == nullptr ? py::dict() : py::reinterpret_borrow<py::dict>(named));
  }
  if (mistake.empty()) {
    error.restore();
  } else {
    PyErr_SetString(PyExc_TypeError, mistake.c_str());
  }
  return nullptr;
}

}  // namespace

void tellOfArguments(py::handle function, const std::string& name) {
  if (PyInstanceMethod_Check(function.ptr())) function = PyInstanceMethod_GET_FUNCTION(function.ptr());
  if (!PyCFunction_Check(function.ptr())) return;
  PyMethodDef* const method = reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
  if (method->ml_doc == nullptr || method->ml_flags != (METH_VARARGS | METH_KEYWORDS)) return;
  auto parameters = parametersOf(method->ml_name == nullptr ? "" : method->ml_name, method->ml_doc);
  PyObject* const record = PyCFunction_GET_SELF(function.ptr());
  if (!parameters || record == nullptr || taken().contains(record)) return;
  const auto isOpen = [](const Parameter& parameter) { return parameter.name.size() > 1 && parameter.name[0] == '*'; };
  if (std::ranges::any_of(*parameters, isOpen)) return;
  // a setter's, which have no names
  if (parameters->size() == 2 && parameters->back().name == "arg1") {
    parameters->front().name = "self";
    parameters->back().name = name;
  }
  const auto star = std::ranges::find(*parameters, "*", &Parameter::name);
  const auto positional = static_cast<std::size_t>(star - parameters->begin());
  if (star != parameters->end()) parameters->erase(star);
  taken().emplace(record, Taken{name, *std::move(parameters), positional});
  const auto call = reinterpret_cast<PyCFunctionWithKeywords>(reinterpret_cast<void (*)()>(method->ml_meth));
  if (dispatcher == nullptr) dispatcher = call;
  if (call == dispatcher) method->ml_meth = reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(callInWords));
}

}  // namespace pongsim::python
