#pragma once

#include <memory>

#include "pongsim/program/log_sink.hh"
#include "ros2/node/node.hh"

namespace pongsim::ros2 {

/// Publishes the process's warnings and errors on /rosout, with rcl's quality of service: late subscribers get the last
/// thousand messages that are at most ten seconds old. A message names its logger as "pongsim.diff-drive of robot": the
/// node, then the source. Stamps are wall time, as in rcl.
class Rosout {
 public:
  explicit Rosout(RosNode& node);

 private:
  std::unique_ptr<RosPublisher> publisher_;
  // destroyed first, because it calls the other
  std::unique_ptr<LogSink> sink_;
};

}  // namespace pongsim::ros2
