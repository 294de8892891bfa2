#pragma once

namespace pongsim::ign {

/// Attaches a kernel filter to the sockets of ign-transport's discovery in this process. It drops packets from other
/// machines, unless the process is open to them: these sockets receive on all interfaces, whatever address the library
/// is told to use. From the library's own sockets it also keeps the kinds of packets that came after ign-transport 11,
/// about each of which the library would print a line.
/// @return The number of sockets.
int filterDiscovery(bool isOpen);

}  // namespace pongsim::ign
