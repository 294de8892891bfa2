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

/// @return Memory of a process [bytes], without mapped files, of which the kernel drops and reloads pages as it likes;
/// 0 if it has ended.
std::uint64_t memoryOf(pid_t pid);

/// @return The names of the files in /dev/shm that a process has mapped.
std::set<std::string> sharedMemoryOf(pid_t pid);

}  // namespace pongsim::test
