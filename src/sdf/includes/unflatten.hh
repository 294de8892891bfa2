#pragma once

#include "pongsim/element.hh"
#include "sdf/context.hh"

namespace pongsim::sdf {

/// To SDF 1.8: in older files an included model was flattened into the one that included it, its links, joints and
/// frames named "inner::link". Each of those becomes a `<model name="inner">` again.
void unflattenAll(Element& root, Context& context);

}  // namespace pongsim::sdf
