#pragma once

#include <ignition/transport/NodeShared.hh>

namespace pongsim::ign {

/// @return ign-transport's state, which all nodes of a process share and which exists until the process ends. All code
/// of this component must call this, rather than `NodeShared::Instance()`, before it creates a node: the first call
/// works around a crash of the library when the process exits.
ignition::transport::NodeShared& library();

}  // namespace pongsim::ign
