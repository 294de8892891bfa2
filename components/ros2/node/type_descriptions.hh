#pragma once

#include <memory>

#include "ros2/node/service.hh"

namespace pongsim::ros2 {

/// Offers `~/get_type_description`, by which tools learn the types that a node uses (REP 2016), from Jazzy on.
std::unique_ptr<RosServer> offerTypeDescriptions(RosNode& node);

}  // namespace pongsim::ros2
