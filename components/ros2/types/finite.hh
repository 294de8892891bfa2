#pragma once

#include <cmath>

#include "ros2/types/reflection.hh"

namespace pongsim::ros2 {

/// @return Whether all numbers in it are finite.
template <class Value>
bool isFinite(const Value& value) {
  if constexpr (std::is_floating_point_v<Value>) {
    return std::isfinite(value);
  } else if constexpr (Structure<Value>) {
    bool finite = true;
    visitFields(value, [&finite](const char*, const auto& field) { finite = finite && isFinite(field); });
    return finite;
  } else if constexpr (kIsArray<Value> || (List<Value> && !std::is_same_v<Value, std::vector<bool>>)) {
    for (const auto& element : value) {
      if (!isFinite(element)) return false;
    }
    return true;
  } else {
    return true;
  }
}

}  // namespace pongsim::ros2
