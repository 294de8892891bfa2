#pragma once

#include <ignition/transport/NodeShared.hh>

namespace pongsim::ign {

/// What ign-transport has once for a process, which begins with the first call and is there to the end. All of this
/// room takes it from here, before it makes a node: what the library leaves to fall over when the process ends is
/// mended by then.
ignition::transport::NodeShared& library();

}  // namespace pongsim::ign
