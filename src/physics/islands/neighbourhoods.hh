#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/islands/islands.hh"

namespace pongsim::physics {

/// Neighbourhoods: sets of bodies connected by joints or by candidate pairs of the broad phase. Bodies of different
/// neighbourhoods cannot touch in this step, so each can make its whole step alone; its islands are parts of it. They
/// come in batches that fit into a processor's cache. Those with many pairs are crowds, kept together behind the
/// batches.
class Neighbourhoods {
 public:
  /// A neighbourhood with more pairs than this is a crowd.
  static constexpr std::size_t kMostPairs = 64;
  /// Number of members at which a batch is full. A robot on two wheels has about ten.
  static constexpr std::size_t kFullBatch = 160;

  /// Numbers of moving bodies, pairs and joints: neighbourhood by neighbourhood, in ascending order in each.
  struct Members {
    std::span<const std::uint32_t> bodies;
    std::span<const std::uint32_t> pairs;
    std::span<const std::uint32_t> joints;
  };

  /// @param pairs Each has at least one body that forces move, as `joints` have.
  /// @param batches About so many are wanted; there are more if these would be too large.
  void form(std::size_t bodies, std::span<const Islands::Ends> pairs, std::span<const Islands::Ends> joints,
            std::size_t batches);

  std::size_t batchCount() const { return starts_.empty() ? 0 : starts_.size() - 2; }
  Members batch(std::size_t number) const;
  /// All of them.
  Members crowds() const { return batch(batchCount()); }

  /// @return The same ends, with each body's place among the bodies of its batch or of the crowds.
  Islands::Ends placesOf(const Islands::Ends& ends) const {
    return {placeOf(ends.first), placeOf(ends.second), placeOf(ends.third)};
  }

 private:
  /// Number of members before a batch.
  struct Start {
    std::size_t bodies;
    std::size_t pairs;
    std::size_t joints;
  };

  bool isCrowd(std::size_t island) const { return islands_.touches(island).size() > kMostPairs; }
  int placeOf(int body) const { return body == kNoMember ? kNoMember : places_[static_cast<std::size_t>(body)]; }
  Start end() const { return {bodies_.size(), pairs_.size(), joints_.size()}; }
  std::size_t fullBatch(std::size_t batches) const;
  void add(std::size_t island);

  Islands islands_;
  /// Of each batch, of the crowds, and where these end.
  std::vector<Start> starts_;
  std::vector<std::uint32_t> bodies_;
  std::vector<std::uint32_t> pairs_;
  std::vector<std::uint32_t> joints_;
  /// Of each body.
  std::vector<int> places_;
};

}  // namespace pongsim::physics
