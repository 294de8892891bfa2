#pragma once

#include <regex>
#include <string>
#include <vector>

namespace pongsim::log {

/// Which topics are recorded: names, and regular expressions (ECMAScript) of whole names.
class TopicChoice {
 public:
  /// @param words A word that is a topic's name, with its slash, stands for that topic, another one is an expression.
  /// None at all: every topic.
  /// @throws UsageError where one is no expression.
  explicit TopicChoice(const std::vector<std::string>& words);

  /// Topics that are wanted whether they are there yet or not.
  const std::vector<std::string>& names() const { return names_; }
  bool has(const std::string& topic) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::regex> patterns_;
};

}  // namespace pongsim::log
