#pragma once

#include <map>
#include <optional>

#include "description/link.hh"
#include "pongsim/types.hh"
#include "pongsim/visual_colors.hh"

namespace pongsim::msgs {

/// Properties that differ from those of the file, because they have been changed since.
struct ChangedProperties {
  struct Mass {
    /// [kg]
    double mass = 0;
    /// How many times the moments of inertia of the file the present ones are.
    double inertiaFactor = 1;
  };
  std::map<VisualId, VisualColors> colors;
  std::map<LinkId, Mass> masses;
};

/// @return The material of a visual with the colours that it has now; nothing if it has none of its own.
std::optional<description::Material> materialNow(const description::Visual& visual, VisualId id,
                                                 const ChangedProperties& changed);

}  // namespace pongsim::msgs
