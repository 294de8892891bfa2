#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "log/record/topic_expression.hh"
#include "log/store/writer.hh"
#include "pongsim/node.hh"
#include "pongsim/types.hh"

namespace pongsim::log {

/// Records topics: those given by name, and those of the simulation whose names match an expression.
class TopicRecorder {
 public:
  /// @param topics Names; a name with any of * ? [ ] ( ) . is a regular expression for the whole name, as in Fortress.
  /// @param failed Called with the reason when the writer stops accepting records.
  /// @throws std::invalid_argument with a sentence if one is neither a name nor an expression.
  TopicRecorder(const Node& node, const std::vector<std::string>& topics, Writer& writer,
                std::function<void(const std::exception&)> failed);

  /// Call before each step: looks for new topics.
  /// @param now Time stamp of messages from here on.
  void update(Time now);

 private:
  void subscribe(const std::string& topic);

  Node node_;
  Writer& writer_;
  std::function<void(const std::exception&)> failed_;
  std::vector<TopicExpression> expressions_;
  std::map<std::string, Subscription> subscriptions_;
  std::uint64_t version_ = 0;
  Time now_{0};
};

}  // namespace pongsim::log
