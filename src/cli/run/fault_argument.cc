#include "cli/run/fault_argument.hh"

#include <algorithm>
#include <memory>
#include <optional>

#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

constexpr const char* kFile = "pongsim-faults-system";
constexpr const char* kHint = "pongsim run WORLD --fault \"drop topic=/lidar probability=0.3 from=2 to=5\"";

Element& faultsOf(std::vector<Element>& systems) {
  const auto found =
      std::ranges::find_if(systems, [](const Element& plugin) { return plugin.attributeOr("filename", "") == kFile; });
  if (found != systems.end()) return *found;
  Element& plugin = systems.emplace_back();
  plugin.name = "plugin";
  plugin.position.file = std::make_shared<const std::string>("--fault");
  plugin.attributes = {{"filename", kFile, plugin.position}, {"name", "pongsim::systems::Faults", plugin.position}};
  return plugin;
}

}  // namespace

void addFault(std::string_view text, std::vector<Element>& systems) {
  Element& plugin = faultsOf(systems);
  Element fault;
  fault.name = "fault";
  fault.position = plugin.position;
  fault.position.line = static_cast<int>(plugin.children.size()) + 1;
  fault.position.column = 1;
  constexpr std::string_view kSpace = " \t\n";
  for (std::size_t begin = text.find_first_not_of(kSpace); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpace, begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    const std::size_t equals = word.find('=');
    SourcePosition position = fault.position;
    position.column = static_cast<int>(begin) + 1;
    if (fault.attributes.empty()) {
      if (equals != std::string_view::npos) {
        throw UsageError("option '--fault' takes a type first, not '" + std::string(word) + "'", kHint);
      }
      fault.attributes.push_back({"type", std::string(word), position});
    } else if (equals == std::string_view::npos || equals == 0) {
      throw UsageError("option '--fault' takes NAME=VALUE after the type, not '" + std::string(word) + "'", kHint);
    } else {
      fault.attributes.push_back({std::string(word.substr(0, equals)), std::string(word.substr(equals + 1)), position});
    }
    begin = text.find_first_not_of(kSpace, end);
  }
  if (fault.attributes.empty()) throw UsageError("option '--fault' takes a fault, and is empty", kHint);
  plugin.children.push_back(std::move(fault));
}

}  // namespace pongsim::cli
