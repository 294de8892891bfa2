#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"
#include "sdf/version.hh"

namespace pongsim::sdf {

/// What happens to elements that the version after the upgrade does not have.
enum class RemovedUse { kDrop, kKeep };

/// Upgrades a file to SDF 1.9, or 1.12 if it is of a later version, so that readers only handle these. Warns about
/// elements that this version does not have if they had an effect.
/// @param root The `<sdf>` element, of version 1.`context.version`.
/// @param least The result is at least of version 1.`least`, 9 or 12: that of the file that includes it.
void upgrade(Element& root, Context& context, RemovedUse removed = RemovedUse::kDrop, int least = kFortressVersion);

}  // namespace pongsim::sdf
