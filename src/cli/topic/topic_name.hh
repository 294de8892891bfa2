#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pongsim {
struct TopicInfo;
}

namespace pongsim::cli {

/// @return The topic that a user names, with its leading slash.
/// @throws UsageError where it can't be a topic's name.
std::string topicOption(std::string_view name);

/// @return "did you mean '/cmd_vel'?" for the topic that is spelt most like `name`, or an empty text.
std::string nearestTopic(std::string_view name, const std::vector<TopicInfo>& known);

}  // namespace pongsim::cli
