#pragma once

#include <string>
#include <string_view>

#include "pongsim/system.hh"

namespace pongsim {

/// Reads parameters in a child element of the `<plugin>`, such as `<broker>`, if it is given. Warns about unknown
/// elements.
/// @param parameters With their targets; need not outlive the call.
/// @throws Error with the position of the first invalid value.
inline void readGroup(const SystemContext& context, std::string_view name, const Declaration& parameters) {
  const Element* group = context.sdf.child(name);
  if (group == nullptr) return;
  for (const Parameter& parameter : parameters.parameters()) parameter.read(*group);
  // all can be read: what remains are the unknown ones
  parameters.read(*group, "<" + std::string(name) + ">", context.diagnostics);
}

}  // namespace pongsim
