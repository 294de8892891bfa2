#pragma once

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// The text that Fortress puts where the format has none to give, as for the name of a link.
inline constexpr std::string_view kNoText = "__default__";

/// Makes of an `<sdf>` element of SDF 1.9 what Fortress's reader keeps of one: each element has what the format says
/// that it must have, with defaults. What the format does not know stands behind what it knows; attributes that it
/// does not know, or that are empty, are gone.
void addDefaultElements(Element& sdf);

}  // namespace pongsim::sdf
