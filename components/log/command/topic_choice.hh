#pragma once

#include <string>
#include <vector>

#include "log/record/topic_expression.hh"

namespace pongsim::log {

/// The topics to record: names, and regular expressions (ECMAScript) for whole names.
class TopicChoice {
 public:
  /// @param words A word that is a topic name with its slash stands for that topic, any other is an expression. None at
  /// all: every topic.
  /// @throws UsageError if one is not a valid expression.
  explicit TopicChoice(const std::vector<std::string>& words);

  /// Topics to record whether or not they exist yet.
  const std::vector<std::string>& names() const { return names_; }
  bool has(const std::string& topic) const;

 private:
  std::vector<std::string> names_;
  std::vector<TopicExpression> expressions_;
};

}  // namespace pongsim::log
