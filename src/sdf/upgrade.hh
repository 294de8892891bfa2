#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// What happens to elements that the version after the upgrade does not have.
enum class RemovedUse { kDrop, kKeep };

/// Upgrades a file to SDF 1.9, or 1.12 if it is of a later version, so that readers only handle these. Warns about
/// elements that this version does not have if they had an effect.
/// @param root The `<sdf>` element, of version 1.`context.version`.
void upgrade(Element& root, Context& context, RemovedUse removed = RemovedUse::kDrop);

}  // namespace pongsim::sdf
