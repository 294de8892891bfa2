#include "core/parameters.hh"

namespace pongsim::python {

namespace {

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

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

/// @param text "count: int = 1"
Parameter parameterOf(std::string_view text) {
  Parameter parameter;
  const std::size_t value = text.rfind(" = ");
  if (value != std::string_view::npos) {
    parameter.value = trimmed(text.substr(value + 3));
    text = text.substr(0, value);
  }
  const std::size_t colon = text.find(':');
  parameter.name = trimmed(text.substr(0, colon));
  if (colon != std::string_view::npos) parameter.type = trimmed(text.substr(colon + 1));
  return parameter;
}

}  // namespace

std::optional<std::vector<Parameter>> parametersOf(std::string_view name, std::string_view doc) {
  if (!doc.starts_with(std::string(name) + "(")) return std::nullopt;
  const std::size_t end = doc.find(") -> ");
  if (end == std::string_view::npos) return std::nullopt;
  std::vector<Parameter> parameters;
  for (const std::string_view text : split(doc.substr(name.size() + 1, end - name.size() - 1))) {
    parameters.push_back(parameterOf(text));
  }
  return parameters;
}

}  // namespace pongsim::python
