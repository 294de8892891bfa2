#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::python {

/// A parameter of a function, as pybind11 describes it: "count: int = 1". A "*", which begins those that go by name
/// only, is one without a type.
struct Parameter {
  std::string name;
  std::string type = {};
  std::optional<std::string> value = std::nullopt;
};

/// @param doc The docstring that pybind11 has made.
/// @return Nothing if it does not begin with a signature, as that of several overloads.
std::optional<std::vector<Parameter>> parametersOf(std::string_view name, std::string_view doc);

}  // namespace pongsim::python
