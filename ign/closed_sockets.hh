#pragma once

namespace pongsim::ign {

/// Has the kernel drop what other machines send to the discovery of ign-transport in this process, which listens at all
/// addresses wherever it is told to speak.
/// @return How many sockets there were.
int closeDiscoveryToOthers();

}  // namespace pongsim::ign
