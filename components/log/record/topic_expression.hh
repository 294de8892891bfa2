#pragma once

#include <memory>
#include <string>

namespace pongsim::log {

/// A regular expression (ECMAScript) for whole names of topics.
class TopicExpression {
 public:
  /// @throws std::invalid_argument with what is wrong, as "Mismatched '(' and ')' in regular expression".
  explicit TopicExpression(const std::string& expression);

  bool matches(const std::string& topic) const;

 private:
  struct Compiled;
  std::shared_ptr<const Compiled> compiled_;
};

}  // namespace pongsim::log
