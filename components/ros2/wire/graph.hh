#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ros2/wire/endpoint.hh"

namespace pongsim::ros2 {

/// The endpoints of the domain's participants, as they announce them. Any thread may use it.
class Graph {
 public:
  enum class Role { kWriter, kReader };
  struct Endpoint {
    Guid id;
    Role role = Role::kWriter;
    Contract contract;
    bool operator==(const Endpoint&) const = default;
  };

  void add(const Endpoint& endpoint);
  void remove(const Guid& endpoint);
  void addParticipant(const Guid& participant);
  /// Including all its endpoints.
  void removeParticipant(const Guid& participant);

  /// @return A number that changes with every change.
  std::uint64_t version() const;
  /// @return Sorted by topic, then by id.
  std::vector<Endpoint> endpoints() const;
  /// @return Nothing if there is none with this id.
  std::optional<Endpoint> find(const Guid& endpoint) const;
  /// @param topic On the wire.
  std::vector<Endpoint> endpointsOn(std::string_view topic, Role role) const;
  std::vector<Guid> participants() const;

 private:
  mutable std::mutex mutex_;
  std::uint64_t version_ = 0;
  std::map<Guid, Endpoint> endpoints_;
  std::vector<Guid> participants_;
};

}  // namespace pongsim::ros2
