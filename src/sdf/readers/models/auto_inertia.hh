#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/link.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// `<inertial auto="true">`: the inertia is computed from the collisions, as in libsdformat 14 and later.
struct AutoInertia {
  /// If given, the inertia is scaled to it [kg].
  std::optional<double> mass;
  /// Of collisions that give none [kg/m^3].
  std::optional<double> density;
  SourcePosition position;
};

/// Reads the element and reports what the computation replaces.
/// @return Nothing if the inertia is not to be computed.
std::optional<AutoInertia> readAutoInertia(const Element& link, const std::string& owner, Context& context);

/// @return The `<density>` of an `<inertial>` or a `<collision>` [kg/m^3].
std::optional<double> readDensity(const Element& element, Context& context);

/// Sets the inertia of a link with resolved collisions.
/// @param densities Of its collisions.
/// @param owner "link 'l'"
void computeInertia(const AutoInertia& automatic, const std::vector<std::optional<double>>& densities,
                    const std::string& owner, description::Link& link, Context& context);

}  // namespace pongsim::sdf
