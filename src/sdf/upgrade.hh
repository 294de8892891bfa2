#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// What becomes of elements that SDF 1.9 has no place for.
enum class RemovedUse { kDrop, kKeep };

/// Brings a file to SDF 1.9, so that readers know that version only. It warns of what 1.9 has no place for where that
/// meant something.
/// @param root The `<sdf>` element, of version 1.`context.version`.
void upgrade(Element& root, Context& context, RemovedUse removed = RemovedUse::kDrop);

}  // namespace pongsim::sdf
