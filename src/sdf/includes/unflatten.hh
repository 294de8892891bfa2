#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// Upgrades to SDF 1.8. In older files, included models were flattened into the enclosing model, with links, joints and
/// frames named "inner::link". This turns them into a `<model name="inner">` again.
void unflattenAll(Element& root, Context& context);

}  // namespace pongsim::sdf
