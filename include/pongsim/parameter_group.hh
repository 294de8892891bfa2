#pragma once

#include <string>
#include <string_view>

#include "pongsim/system.hh"

namespace pongsim {

/// Reads parameters that stand together below an element of the `<plugin>`, such as `<broker>`, if that is there.
/// What is no parameter is warned of.
/// @param parameters With their targets; it need not outlive the call.
/// @throws Error for the first that can't be used, with its place.
inline void readGroup(const SystemContext& context, std::string_view name, const Declaration& parameters) {
  const Element* group = context.sdf.child(name);
  if (group == nullptr) return;
  for (const Parameter& parameter : parameters.parameters()) parameter.read(*group);
  // all can be read: what remains are the unknown ones
  parameters.read(*group, "<" + std::string(name) + ">", context.diagnostics);
}

}  // namespace pongsim
