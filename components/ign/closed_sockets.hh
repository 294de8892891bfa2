#pragma once

namespace pongsim::ign {

/// Attaches a kernel filter to the sockets of ign-transport's discovery in this process, which drops packets from other
/// machines. These sockets receive on all interfaces, whatever address the library is told to use.
/// @return The number of sockets.
int closeDiscoveryToOthers();

}  // namespace pongsim::ign
