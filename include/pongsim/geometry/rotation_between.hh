#pragma once

#include "pongsim/export.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// @param from, to Of any length but zero.
/// @return The smallest rotation that turns the direction of `from` into that of `to`; of opposite ones half a turn
/// about some axis across them.
PONGSIM_API Quaternion rotationBetween(const Vector3& from, const Vector3& to);

}  // namespace pongsim
