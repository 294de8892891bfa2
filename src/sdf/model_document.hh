#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"

namespace pongsim::sdf {

/// As `parseDocument`, for a file that describes something: an `<sdf>`, or a `<robot>` in URDF, which becomes one.
/// @return The `<sdf>` element; nothing, and errors added, where there is none.
std::optional<Element> parseModelDocument(std::string_view text, std::shared_ptr<const std::string> file,
                                          Diagnostics& diagnostics);

}  // namespace pongsim::sdf
