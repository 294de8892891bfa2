#include "cli/topic/topic_name.hh"

#include "base/nearest_word.hh"
#include "pongsim/node.hh"
#include "shared/program/failure.hh"
#include "transport/names/topic_name.hh"

namespace pongsim::cli {

std::string topicOption(std::string_view name) {
  if (const std::optional<std::string> error = topicNameError(name)) {
    throw UsageError("'" + std::string(name) + "' is not a topic name: it " + *error);
  }
  return transport::absoluteTopic(name);
}

std::string nearestTopic(std::string_view name, const std::vector<TopicInfo>& known) {
  std::vector<std::string_view> names;
  for (const TopicInfo& topic : known) {
    if (topic.name != name) names.push_back(topic.name);
  }
  return base::didYouMean(name, names);
}

}  // namespace pongsim::cli
