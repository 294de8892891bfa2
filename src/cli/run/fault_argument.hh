#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pongsim/element.hh"

namespace pongsim::cli {

/// Adds a fault to the systems of a run: a `<fault>` in the `<plugin>` of the system that makes them, which it adds if
/// it is not there.
/// @param text "TYPE NAME=VALUE...", as in "drop topic=/lidar probability=0.3". Only its form is checked here; its
/// errors name the option, its number among these options as the line, and the column in the text.
/// @throws UsageError
void addFault(std::string_view text, std::vector<Element>& systems);

}  // namespace pongsim::cli
