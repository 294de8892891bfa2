#include "ros2/controllers/remaps.hh"

namespace pongsim::ros2 {

bool Remaps::add(const std::string& rule) {
  const std::size_t sign = rule.find(":=");
  if (sign == std::string::npos || sign == 0 || sign + 2 == rule.size()) return false;
  Rule added{"", rule.substr(0, sign), rule.substr(sign + 2)};
  if (const std::size_t colon = added.from.find(':'); colon != std::string::npos) {
    added.node = added.from.substr(0, colon);
    added.from.erase(0, colon + 1);
  }
  if (!added.from.starts_with("__")) rules_.push_back(std::move(added));
  return true;
}

void Remaps::addArguments(std::span<const std::string> arguments) {
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    if (arguments[i] == "-r" || arguments[i] == "--remap") add(arguments[i + 1]);
  }
}

std::string Remaps::apply(const RosNode& node, const std::string& name) const {
  const std::string resolved = node.resolve(name);
  for (const Rule& rule : rules_) {
    if (!rule.node.empty() && rule.node != node.options().name) continue;
    if (node.resolve(rule.from) == resolved) return node.resolve(rule.to);
  }
  return resolved;
}

}  // namespace pongsim::ros2
