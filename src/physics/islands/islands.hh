#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/contacts/touch.hh"

namespace pongsim::physics {

/// The islands of bodies: sets of moving bodies that touches and joints connect with each other. (Union-find: R. E.
/// Tarjan, Efficiency of a good but not linear set union algorithm, JACM 22, 1975.) An island's bodies, touches and
/// joints are in ascending order; islands are in the order of their first bodies.
class Islands {
 public:
  /// Numbers of the bodies that touch or that a joint connects, a gearbox even three; `kNoMember` for bodies that
  /// forces do not move, but not for all.
  struct Ends {
    int first = kNoMember;
    int second = kNoMember;
    int third = kNoMember;
    bool operator==(const Ends&) const = default;
  };

  void form(std::size_t bodies, std::span<const Ends> touches, std::span<const Ends> joints);

  std::size_t count() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  std::span<const std::uint32_t> bodies(std::size_t island) const;
  std::span<const std::uint32_t> touches(std::size_t island) const;
  std::span<const std::uint32_t> joints(std::size_t island) const;

 private:
  /// Numbers of members, or where the members begin.
  struct Counts {
    std::uint32_t bodies = 0;
    std::uint32_t touches = 0;
    std::uint32_t joints = 0;
  };

  void unite(const Ends& ends);
  void unite(int a, int b);
  std::uint32_t rootOf(std::uint32_t body);
  void number();
  Counts& countsOf(const Ends& ends, std::vector<Counts>& counts);
  void sumUp();

  /// For each body, a connected body before it, or itself; at the end its island.
  std::vector<std::uint32_t> parents_;
  /// Of each island, and the end of the last one.
  std::vector<Counts> starts_;
  std::vector<Counts> next_;
  std::vector<std::uint32_t> bodies_;
  std::vector<std::uint32_t> touches_;
  std::vector<std::uint32_t> joints_;
};

}  // namespace pongsim::physics
