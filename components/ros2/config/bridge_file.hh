#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/config/rule_text.hh"

namespace pongsim::ros2 {

/// Parses a configuration of ros_gz_bridge: a YAML list of maps, each of which is a topic or a service. Accepts all
/// keys of ros_gz from Humble to Rolling, and some of our own (docs/ros2.md). Warns about unknown keys.
/// @param name The file's name, for messages.
/// @return The valid rules, in the order of the file; errors are added to `diagnostics`, with line and column.
std::vector<RuleText> readBridgeText(std::string_view text, const std::string& name, Diagnostics& diagnostics);

/// Like `readBridgeText`, from a file of up to 16 MiB.
std::vector<RuleText> readBridgeFile(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace pongsim::ros2
