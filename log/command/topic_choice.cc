#include "log/command/topic_choice.hh"

#include <algorithm>

#include "pongsim/node.hh"
#include "programs/failure.hh"

namespace pongsim::log {

namespace {

bool isName(const std::string& word) {
  return word.starts_with('/') && word.find_first_of("\\^$.|?*+()[]{}") == std::string::npos && !topicNameError(word);
}

}  // namespace

TopicChoice::TopicChoice(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (isName(word)) {
      names_.push_back(word);
      continue;
    }
    try {
      patterns_.emplace_back(word);
    } catch (const std::regex_error& error) {
      throw programs::UsageError("'" + word + "' is neither a topic nor a regular expression: " + error.what(),
                                 "as /odom, or '/model/.*'");
    }
  }
  if (words.empty()) patterns_.emplace_back(".+");
}

bool TopicChoice::has(const std::string& topic) const {
  if (std::ranges::count(names_, topic) > 0) return true;
  return std::ranges::any_of(patterns_, [&topic](const std::regex& each) { return std::regex_match(topic, each); });
}

}  // namespace pongsim::log
