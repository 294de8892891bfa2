#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// What happens to elements that SDF 1.9 does not have.
enum class RemovedUse { kDrop, kKeep };

/// Upgrades a file to SDF 1.9, so that readers only handle that version. Warns about elements that 1.9 does not have if
/// they had an effect.
/// @param root The `<sdf>` element, of version 1.`context.version`.
void upgrade(Element& root, Context& context, RemovedUse removed = RemovedUse::kDrop);

}  // namespace pongsim::sdf
