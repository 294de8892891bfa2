#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ros2/types/reflection.hh"

/// The node graph.
namespace pongsim::ros2::rmw_dds_common {

/// Sizes of ids up to Humble, and from Iron on.
inline constexpr std::size_t kHumbleGid = 24;
inline constexpr std::size_t kJazzyGid = 16;

template <std::size_t GidSize>
struct Gid {
  static constexpr const char* kName = "rmw_dds_common/msg/Gid";
  std::array<std::uint8_t, GidSize> data{};
  static void visit(auto& self, auto&& field) { field("data", self.data); }
  bool operator==(const Gid&) const = default;
};

template <std::size_t GidSize>
struct NodeEntitiesInfo {
  static constexpr const char* kName = "rmw_dds_common/msg/NodeEntitiesInfo";
  BoundedString<256> node_namespace;
  BoundedString<256> node_name;
  std::vector<Gid<GidSize>> reader_gid_seq;
  std::vector<Gid<GidSize>> writer_gid_seq;
  static void visit(auto& self, auto&& field) {
    field("node_namespace", self.node_namespace);
    field("node_name", self.node_name);
    field("reader_gid_seq", self.reader_gid_seq);
    field("writer_gid_seq", self.writer_gid_seq);
  }
  bool operator==(const NodeEntitiesInfo&) const = default;
};

template <std::size_t GidSize>
struct ParticipantEntitiesInfo {
  static constexpr const char* kName = "rmw_dds_common/msg/ParticipantEntitiesInfo";
  Gid<GidSize> gid;
  std::vector<NodeEntitiesInfo<GidSize>> node_entities_info_seq;
  static void visit(auto& self, auto&& field) {
    field("gid", self.gid);
    field("node_entities_info_seq", self.node_entities_info_seq);
  }
  bool operator==(const ParticipantEntitiesInfo&) const = default;
};

}  // namespace pongsim::ros2::rmw_dds_common
