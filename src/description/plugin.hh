#pragma once

#include <string>

#include "pongsim/element.hh"

namespace pongsim::description {

/// A `<plugin>`: its library, class and parameters.
struct Plugin {
  std::string filename;
  std::string className;
  /// The whole `<plugin>` element, with its position.
  Element sdf;
  bool operator==(const Plugin&) const = default;
};

}  // namespace pongsim::description
