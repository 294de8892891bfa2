#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pongsim::physics {

/// The moving bodies that a joint acts on, by their numbers in the island; -1 for none.
using JointBodies = std::array<int, 3>;

/// The order in which the joints of an island are eliminated, and which of them are coupled then. Two joints are
/// coupled if they act on the same body, or if both were coupled with an eliminated joint (fill-in). The order is one
/// of minimum degree: it takes a tree from its leaves to its root, without fill-in, so the cost is linear in the number
/// of joints; loops add little. Joints of a subtree are next to each other.
///
/// Reference: A. George, J. W. H. Liu, Computer Solution of Large Sparse Positive Definite Systems, 1981, chapter 5; J.
/// W. H. Liu, The role of elimination trees in sparse factorization, SIAM Journal on Matrix Analysis 11, 1990.
class JointOrder {
 public:
  /// Finds the order of these.
  void find(std::span<const JointBodies> joints);
  /// @return Whether the order is that of these joints.
  bool isOf(std::span<const JointBodies> joints) const;

  /// @return How many joints there are: places in the order are below that.
  std::size_t count() const { return order_.size(); }
  /// @return Which joint is at a place, and the place of a joint.
  int jointAt(int place) const { return order_[static_cast<std::size_t>(place)]; }
  int placeOf(int joint) const { return placeOf_[static_cast<std::size_t>(joint)]; }
  /// @return The places behind this one that it is coupled with when it is eliminated, ascending.
  std::span<const int> later(int place) const;
  /// @return The first place of a joint that acts on the body, -1 for none.
  int firstAt(int body) const;
  /// @return Whether joints hang together that are not coupled with each other, so that an order matters.
  bool isDeep() const { return isDeep_; }

 private:
  std::vector<JointBodies> joints_;
  std::vector<int> order_;
  std::vector<int> placeOf_;
  std::vector<int> firstAt_;
  /// Where each place's `later_` begin; one more than there are.
  std::vector<std::size_t> starts_;
  std::vector<int> later_;
  bool isDeep_ = false;
};

/// @return Whether all joints act on one body, such as a robot's chassis: then no order is better than another.
bool haveOneHub(std::span<const JointBodies> joints);

/// A cache of orders, so that an island that keeps its joints finds its order again.
class JointOrders {
 public:
  const JointOrder& find(std::span<const JointBodies> joints);

 private:
  static constexpr std::size_t kKept = 64;
  /// By a hash of the joints.
  std::array<JointOrder, kKept> orders_;
};

}  // namespace pongsim::physics
