#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "physics/contacts/touch.hh"

namespace pongsim::physics {

/// Which bodies are connected: numbers of bodies that forces move, sorted by the groups that they form. A group has its
/// bodies, touches and joints in ascending order, and is known by its first body.
class Groups {
 public:
  /// Numbers of the two bodies that touch or that a joint connects; `kNoMember` for what forces do not move.
  using Ends = std::pair<int, int>;

  /// @param touches Each of at least one body that forces move, as `joints` are.
  void form(std::size_t bodies, std::span<const Ends> touches, std::span<const Ends> joints);

  std::size_t count() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  std::span<const std::uint32_t> bodies(std::size_t group) const;
  std::span<const std::uint32_t> touches(std::size_t group) const;
  std::span<const std::uint32_t> joints(std::size_t group) const;

 private:
  /// Numbers of members, or places of the first ones.
  struct Counts {
    std::uint32_t bodies = 0;
    std::uint32_t touches = 0;
    std::uint32_t joints = 0;
  };

  void unite(const Ends& ends);
  std::uint32_t rootOf(std::uint32_t body);
  void number();
  Counts& countsOf(const Ends& ends, std::vector<Counts>& counts);
  void sumUp();

  /// Of each body, one that it is connected with and that stands before it, or itself; then its group.
  std::vector<std::uint32_t> parents_;
  /// Of each group; one more than there are, for the end of the last.
  std::vector<Counts> starts_;
  std::vector<Counts> next_;
  std::vector<std::uint32_t> bodies_;
  std::vector<std::uint32_t> touches_;
  std::vector<std::uint32_t> joints_;
};

}  // namespace pongsim::physics
