#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pongsim::cli {

/// @return x of "1.x", where that is a version of SDF that is described: 1.4 to 1.9.
std::optional<int> sdfVersion(std::string_view text);

/// All elements and attributes of SDF 1.`version`, in the XML form of `ign sdf --describe`. An element that may stand
/// in itself is described once, and named where it stands within.
std::string schemaText(int version);

}  // namespace pongsim::cli
