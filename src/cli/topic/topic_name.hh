#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pongsim {
struct TopicInfo;
}

namespace pongsim::cli {

/// @return The topic named by the user, with its leading slash.
/// @throws UsageError if it is not a valid topic name.
std::string topicOption(std::string_view name);

/// @return "did you mean '/cmd_vel'?" for the topic with the most similar name, or an empty text.
std::string nearestTopic(std::string_view name, const std::vector<TopicInfo>& known);

}  // namespace pongsim::cli
