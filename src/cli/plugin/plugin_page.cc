#include "cli/plugin/plugin_page.hh"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "plugin/system_name.hh"
#include "pongsim/system.hh"

namespace pongsim::cli {

namespace {

using Endpoint = Declaration::Endpoint;

const char* placeText(Declaration::Place place) {
  switch (place) {
    case Declaration::Place::kWorld:
      return "the <world>";
    case Declaration::Place::kModel:
      return "a <model>";
    case Declaration::Place::kActor:
      return "an <actor>";
    default:
      return "the <world> or a <model>";
  }
}

std::string whereItBelongs(const plugin::CoreSystem& system) {
  return system.holders.empty() ? placeText(system.declaration.place()) : system.holders;
}

const char* verb(Endpoint::Kind kind) {
  switch (kind) {
    case Endpoint::Kind::kPublished:
      return "publishes";
    case Endpoint::Kind::kSubscribed:
      return "subscribes to";
    default:
      return "offers";
  }
}

/// @return "number [m]".
std::string typeText(const Parameter& parameter) {
  return parameter.type() + (parameter.unit().empty() ? "" : " [" + parameter.unit() + "]");
}

/// @return "required, repeated", or its default.
std::string defaultText(const Parameter& parameter) {
  std::string text = parameter.isRequired() ? "required" : parameter.fallback();
  if (parameter.isRepeated()) text += text.empty() ? "repeated" : ", repeated";
  return text;
}

std::string typesOf(const Endpoint& endpoint) {
  return endpoint.type + (endpoint.replyType.empty() ? "" : ", " + endpoint.replyType);
}

/// Adds the rows; all columns but the last are as wide as needed.
void addTable(const std::vector<std::vector<std::string>>& rows, std::string& text) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  for (const std::vector<std::string>& row : rows) {
    text += " ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += " " + row[i];
      if (i + 1 < row.size()) text.append(widths[i] - row[i].size() + 1, ' ');
    }
    text += "\n";
  }
}

/// @return The text with characters escaped that Markdown takes for a tag or a column separator, except in code.
std::string escaped(const std::string& text) {
  std::string result;
  bool isCode = false;
  for (const char letter : text) {
    if (letter == '`') isCode = !isCode;
    if (letter == '|' || (letter == '<' && !isCode)) result += '\\';
    result += letter;
  }
  return result;
}

/// @return The parameters to show, one for each family, with the names to show.
std::vector<std::pair<std::string, const Parameter*>> shownParameters(const Declaration& declaration) {
  std::vector<std::pair<std::string, const Parameter*>> shown;
  for (const Parameter& parameter : declaration.parameters()) {
    const bool isAlone = parameter.family().empty();
    const std::string name = "<" + (isAlone ? parameter.name() : parameter.family()) + ">";
    if (isAlone || shown.empty() || shown.back().first != name) shown.emplace_back(name, &parameter);
  }
  return shown;
}

/// @param place Where its `<plugin>` belongs.
void addClassText(const std::vector<std::string>& names, const Declaration& declaration, const std::string& place,
                  std::string& text) {
  text += "\nclass " + names.front();
  for (std::size_t i = 1; i < names.size(); ++i) text += (i == 1 ? ", also " : ", ") + names[i];
  text += "\n";
  if (declaration.text().empty()) return;
  text += declaration.text() + "\nBelongs in " + place + ".\n";
  std::vector<std::vector<std::string>> rows;
  for (const auto& [shownName, parameter] : shownParameters(declaration)) {
    rows.push_back({shownName, typeText(*parameter), defaultText(*parameter), parameter->text()});
  }
  if (!rows.empty()) text += "parameters, with type, default and meaning:\n";
  addTable(rows, text);
  rows.clear();
  for (const Endpoint& endpoint : declaration.endpoints())
    rows.push_back({verb(endpoint.kind), endpoint.name, typesOf(endpoint), endpoint.text});
  if (!rows.empty()) text += "topics and services, with types:\n";
  addTable(rows, text);
}

void addClassMarkdown(const std::string& name, const Declaration& declaration, const std::string& place,
                      const std::string& filename, std::string& text) {
  text += "## " + name.substr(name.rfind(':') == std::string::npos ? 0 : name.rfind(':') + 1) + "\n" +
          declaration.text() + "\n\nfilename `" + filename + "`, class `" + name + "`; belongs in " + escaped(place) +
          "\n";
  if (!declaration.parameters().empty()) {
    text += "\n| parameter | type | default | meaning |\n|---|---|---|---|\n";
    for (const auto& [shownName, parameter] : shownParameters(declaration)) {
      text += "| `" + shownName + "` | " + typeText(*parameter) + " | " + escaped(defaultText(*parameter)) + " | " +
              escaped(parameter->text()) + " |\n";
    }
  }
  if (!declaration.endpoints().empty()) {
    text += "\n| | topic or service | types | |\n|---|---|---|---|\n";
    for (const Endpoint& endpoint : declaration.endpoints()) {
      text += std::string("| ") + verb(endpoint.kind) + " | `" + endpoint.name + "` | " + typesOf(endpoint) + " | " +
              escaped(endpoint.text) + " |\n";
    }
  }
}

/// @return The name used in Fortress's worlds, or in those of later releases for a system that only they have.
std::string worldsFilename(const std::string& name, std::string_view className) {
  const char* const project = className.starts_with("gz::")        ? "gz-sim-"
                              : className.starts_with("pongsim::") ? "pongsim-"
                                                                   : "ignition-gazebo-";
  return project + name + "-system";
}

}  // namespace

std::string pluginText(const plugin::Inspection& inspection) {
  std::string text = inspection.file().string() + "\nplugin interface version " + std::to_string(kAbiVersion) + "\n";
  for (const auto& found : inspection.classes())
    addClassText(found.names, found.declaration, placeText(found.declaration.place()), text);
  return text;
}

std::string pluginText(const plugin::CoreSystem& system) {
  std::string text = "part of pongsim itself\n";
  addClassText({system.className}, system.declaration, whereItBelongs(system), text);
  return text;
}

std::string pluginMarkdown(const plugin::Inspection& inspection) {
  const std::string file = inspection.file().filename().string();
  const std::string name = plugin::systemName(file);
  std::string text;
  for (const auto& found : inspection.classes()) {
    const std::string& className = found.names.front();
    const std::string filename = file.starts_with("libpongsim-") ? worldsFilename(name, className) : name;
    addClassMarkdown(className, found.declaration, placeText(found.declaration.place()), filename, text);
  }
  return text;
}

std::string pluginMarkdown(const plugin::CoreSystem& system) {
  std::string text;
  addClassMarkdown(system.className, system.declaration, whereItBelongs(system), worldsFilename(system.name, system.className),
                   text);
  return text + "\nPart of pongsim itself.\n";
}

}  // namespace pongsim::cli
