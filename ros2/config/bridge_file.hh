#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/config/rule_text.hh"

namespace pongsim::ros2 {

/// Reads a configuration of ros_gz_bridge: a list of maps in YAML, of which each is a topic or a service. It takes all
/// keys of ros_gz from Humble to Rolling, and some of our own (docs/ros2.md). A key that it does not know is a warning.
/// @param name Of the file, for the messages.
/// @return The rules that could be read, in the order of the file; what is wrong is added to `diagnostics`, with line
/// and column.
std::vector<RuleText> readBridgeText(std::string_view text, const std::string& name, Diagnostics& diagnostics);

/// As `readBridgeText`, from a file, which may have up to 16 MiB.
std::vector<RuleText> readBridgeFile(const std::filesystem::path& file, Diagnostics& diagnostics);

}  // namespace pongsim::ros2
