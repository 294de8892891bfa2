#pragma once

#include <chrono>
#include <vector>

#include "pongsim/node.hh"

namespace pongsim::cli {

/// How long a look around waits for the other processes to tell what they offer. It ends when they have, or when
/// nothing new comes: only a hundred of them on a busy machine take as long.
inline constexpr std::chrono::seconds kDiscoveryTime{30};

/// `Transport::discover`, with a warning on stderr where a process has not answered.
std::vector<TopicInfo> topicsAround(Transport& transport);

/// `Transport::discoverServices`, with the same warning.
std::vector<ServiceInfo> servicesAround(Transport& transport);

}  // namespace pongsim::cli
