#pragma once

#include <ignition/transport/NodeShared.hh>

namespace pongsim::ign {

/// ign-transport's state shared by all nodes of a process, which exists from the first call to the end. All of this
/// component's code gets it here before it creates a node; by then, what makes the library fail when the process exits
/// has been worked around.
ignition::transport::NodeShared& library();

}  // namespace pongsim::ign
