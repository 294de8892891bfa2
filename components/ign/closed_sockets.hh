#pragma once

namespace pongsim::ign {

/// Makes the kernel drop packets from other machines to ign-transport's discovery in this process, which listens on all
/// addresses regardless of where it is told to send.
/// @return The number of sockets.
int closeDiscoveryToOthers();

}  // namespace pongsim::ign
