#pragma once

#include <sys/types.h>

#include <cstdint>
#include <set>
#include <string>

namespace pongsim::test {

/// @param table Of /proc/net: "udp", "udp6", "tcp" or "tcp6".
/// @return Local addresses and ports of a process's sockets, as that table prints them: "0100007F:1CF2" for port 7410
/// of 127.0.0.1.
std::set<std::string> socketsOf(pid_t pid, const std::string& table);

/// @return Bytes of memory that a process takes now, without the files that it has mapped, whose pages come and go with
/// what else the machine does; 0 where it has ended.
std::uint64_t memoryOf(pid_t pid);

/// @return The names in /dev/shm of what a process has mapped.
std::set<std::string> sharedMemoryOf(pid_t pid);

}  // namespace pongsim::test
