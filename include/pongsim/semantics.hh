#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pongsim {

/// `<gz:semantics>` of a model: what it stands for in the world.
struct Semantics {
  /// Category of simulation_interfaces: 0 object, 1 robot, 2 human, 4 dynamic object, 5 static object.
  std::optional<std::uint8_t> category;
  std::string description;
  std::vector<std::string> tags;
  bool operator==(const Semantics&) const = default;
};

}  // namespace pongsim
