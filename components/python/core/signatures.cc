#include "core/signatures.hh"

#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::python {

namespace py = pybind11;

namespace {

/// @return What is between commas that are in no brackets and no string.
std::vector<std::string_view> split(std::string_view list) {
  std::vector<std::string_view> parts;
  int depth = 0;
  char quote = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= list.size(); ++i) {
    if (i == list.size() || (list[i] == ',' && depth == 0 && quote == 0)) {
      if (i > begin) parts.push_back(list.substr(begin, i - begin));
      begin = i + 1;
    } else if (quote != 0) {
      if (list[i] == quote) quote = 0;
    } else if (list[i] == '\'' || list[i] == '"') {
      quote = list[i];
    } else if (std::string_view("([{").find(list[i]) != std::string_view::npos) {
      ++depth;
    } else if (std::string_view(")]}").find(list[i]) != std::string_view::npos) {
      --depth;
    }
  }
  return parts;
}

/// @param parameter "count: int = 1"
/// @return "count=1"
std::string plain(std::string_view parameter) {
  while (parameter.starts_with(' ')) parameter.remove_prefix(1);
  const std::size_t colon = parameter.find(':');
  if (colon == std::string_view::npos) return std::string(parameter);
  std::string result(parameter.substr(0, colon));
  const std::size_t value = parameter.rfind(" = ");
  if (value != std::string_view::npos) result += "=" + std::string(parameter.substr(value + 3));
  return result;
}

/// @return The docstring in Python's form; empty if pybind11 has not made it, for several overloads, and for parameters
/// without names.
std::string rewritten(const std::string& name, std::string_view doc) {
  if (!doc.starts_with(name + "(")) return {};
  const std::size_t end = doc.find(") -> ");
  if (end == std::string_view::npos) return {};
  std::string result = name + "(";
  bool isFirst = true;
  for (const std::string_view parameter : split(doc.substr(name.size() + 1, end - name.size() - 1))) {
    const std::string text = plain(parameter);
    // pybind11's name for one without a name: a function for the package itself
    if (text.starts_with("arg0")) return {};
    result += (isFirst ? "" : ", ") + text;
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
    for (const auto& [part, function] : py::dict(thing.attr("__dict__"))) giveSignature(function);
  }
}

}  // namespace pongsim::python
