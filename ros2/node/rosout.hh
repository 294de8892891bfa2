#pragma once

#include <memory>

#include "pongsim/program/log_sink.hh"
#include "ros2/node/node.hh"

namespace pongsim::ros2 {

/// Tells on /rosout, for as long as it lives, what all loggers of the process warn of, with the quality of service that
/// rcl gives it: who comes late gets the last thousand messages, unless they are older than ten seconds. A message
/// names its logger as "pongsim.diff-drive of robot": the node, then who speaks. Stamps are wall time, as rcl's are.
class Rosout {
 public:
  explicit Rosout(RosNode& node);

 private:
  std::unique_ptr<RosPublisher> publisher_;
  // ends first, for it calls the other
  std::unique_ptr<LogSink> sink_;
};

}  // namespace pongsim::ros2
