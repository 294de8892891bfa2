#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "ros2/wire/participant.hh"

namespace pongsim::ros2 {

/// Announces the nodes of a participant, with their endpoints, on `ros_discovery_info`. Any thread may use it; must not
/// outlive the participant.
class NodeAnnouncement {
 public:
  struct Entry {
    /// "/" or "/robot".
    std::string nameSpace;
    std::string name;
    std::vector<Guid> readers;
    std::vector<Guid> writers;
  };

  explicit NodeAnnouncement(Participant& participant);

  /// Announces a node, instead of what was announced of it before.
  /// @param node Identifies it.
  void announce(const void* node, Entry entry);
  /// Announces that a node is gone.
  void remove(const void* node);

 private:
  template <std::size_t GidSize>
  void writeBy(Writer& writer) const;
  void write();

  Participant& participant_;
  std::mutex mutex_;
  std::vector<std::pair<const void*, Entry>> entries_;
  /// The layout of the announcement is another one up to Humble: each is sent to those that read it.
  std::unique_ptr<Writer> toHumble_;
  std::unique_ptr<Writer> toOthers_;
};

}  // namespace pongsim::ros2
