#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::sdf {

/// Parses XML as leniently as Fortress: it accepts "--" in comments, undeclared name prefixes and stray text.
/// @param file Name of the text in diagnostics.
/// @return The root element with the position of every part (an element's is that of its "<"); nothing, with one error,
/// if the text is not well-formed.
std::optional<Element> parseDocument(std::string_view text, std::shared_ptr<const std::string> file,
                                     Diagnostics& diagnostics);

}  // namespace pongsim::sdf
