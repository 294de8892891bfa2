#pragma once

#include <cstdint>
#include <string>

#include "pongsim/element.hh"
#include "pongsim/export.hh"

namespace pongsim {

/// Reads the file that a parameter of a system names: a path relative to the folder of the world's file or to a
/// resource folder, or "model://NAME/FILE". A system that does so says `Declaration::usesFiles`.
/// @param largest Size limit [bytes].
/// @throws Error with the position of the element if there is no regular file of at most that size, or it can't be
/// read.
PONGSIM_API std::string parameterFile(const Element& element, std::uint64_t largest);

}  // namespace pongsim
