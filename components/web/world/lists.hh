#pragma once

#include <string>
#include <vector>

#include "pongsim/service.hh"

namespace pongsim::web {

/// A topic of a world, as reported to clients.
struct Topic {
  std::string name;
  /// Full name of the message type.
  std::string type;
  /// Publishers of the world, of bridges to it, and of clients.
  int publishers = 0;
  /// Subscriptions of the world, not counting clients.
  int subscribers = 0;
  /// Whether the last message is kept for late subscribers.
  bool isLatched = false;
  bool operator==(const Topic&) const = default;
};

/// The topics and services of a world.
struct Lists {
  /// Sorted by name, then by type.
  std::vector<Topic> topics;
  /// Sorted by name.
  std::vector<OwnService> services;
  bool operator==(const Lists&) const = default;
};

}  // namespace pongsim::web
