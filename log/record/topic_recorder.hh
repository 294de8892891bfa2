#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "log/store/writer.hh"
#include "pongsim/node.hh"
#include "pongsim/types.hh"

namespace pongsim::log {

/// Writes the messages of topics: those that are named, and those of the simulation whose names expressions match.
class TopicRecorder {
 public:
  /// @param topics Names; one with any of * ? [ ] ( ) . is a regular expression for all of a name, as Fortress has it.
  /// @param failed Told why the writer takes no more.
  /// @throws std::invalid_argument for what is neither, with a sentence that says so.
  TopicRecorder(const Node& node, const std::vector<std::string>& topics, Writer& writer,
                std::function<void(const std::exception&)> failed);

  /// Before each step: looks whether there are new topics.
  /// @param now What stands as the time of messages from here on.
  void update(Time now);

 private:
  void subscribe(const std::string& topic);

  Node node_;
  Writer& writer_;
  std::function<void(const std::exception&)> failed_;
  std::vector<std::regex> expressions_;
  std::map<std::string, Subscription> subscriptions_;
  std::uint64_t version_ = 0;
  Time now_{0};
};

}  // namespace pongsim::log
