#include "log/command/topic_choice.hh"

#include <algorithm>
#include <stdexcept>

#include "pongsim/node.hh"
#include "shared/program/failure.hh"

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
      expressions_.emplace_back(word);
    } catch (const std::invalid_argument& error) {
      throw cli::UsageError("'" + word + "' is neither a topic nor a regular expression: " + error.what(),
                            "such as /odom or '/model/.*'");
    }
  }
  if (words.empty()) expressions_.emplace_back(".+");
}

bool TopicChoice::has(const std::string& topic) const {
  if (std::ranges::count(names_, topic) > 0) return true;
  return std::ranges::any_of(expressions_, [&topic](const TopicExpression& each) { return each.matches(topic); });
}

}  // namespace pongsim::log
