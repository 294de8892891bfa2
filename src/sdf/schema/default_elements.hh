#pragma once

#include "pongsim/element.hh"

namespace pongsim::sdf {

/// Fortress's value where the format has no default, such as the name of a link.
inline constexpr std::string_view kNoText = "__default__";

/// Changes an `<sdf>` element of SDF 1.`version` to what libsdformat's reader makes of it: required elements are added
/// with their defaults. Elements unknown to this version go after the known ones; unknown and empty attributes are
/// removed.
void addDefaultElements(Element& sdf, int version);

}  // namespace pongsim::sdf
