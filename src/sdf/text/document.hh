#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::sdf {

/// Reads XML, as leniently as Fortress does: "--" in comments, undeclared name prefixes, stray text.
/// @param file What diagnostics call the text.
/// @return The root element with the position of every part (an element's is that of its "<"), or nothing, and one
/// error added, where the text is not well-formed.
std::optional<Element> parseDocument(std::string_view text, std::shared_ptr<const std::string> file,
                                     Diagnostics& diagnostics);

}  // namespace pongsim::sdf
