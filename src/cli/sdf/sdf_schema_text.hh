#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::cli {

/// @return The x of "1.x", if that version of SDF is described: 1.4 to 1.12.
std::optional<int> sdfVersion(std::string_view text);

/// All elements and attributes of SDF 1.`version`, in the XML format of `ign sdf --describe`. An element that can
/// contain itself is described once, and only named where it recurs.
std::string schemaText(int version);

}  // namespace pongsim::cli
