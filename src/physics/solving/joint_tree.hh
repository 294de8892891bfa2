#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace pongsim::physics {

/// The moving bodies that a joint acts on, by their numbers in the island; -1 for none.
struct JointBodies {
  int parent = -1;
  int child = -1;
  /// Of a gearbox: what its axes are fixed to.
  int reference = -1;
  /// Whether it holds parent and child together, as all but gearboxes do.
  bool holds = true;

  bool operator==(const JointBodies&) const = default;
};

/// The trees that the joints of an island make of its bodies. Each grows from the world, or else from the body that
/// comes first.
class JointTree {
 public:
  /// A body that a joint holds to the one before it, or to the world (-1).
  struct Link {
    int joint;
    int body;
    int parent;
    /// Whether the body is the joint's parent.
    bool isReversed;
  };

  /// Finds the trees of these.
  void find(std::span<const JointBodies> joints);
  /// @return Whether the trees are those of these joints.
  bool isOf(std::span<const JointBodies> joints) const;

  /// @return All links; the parent of each comes before it.
  std::span<const Link> links() const { return links_; }
  /// @return The link of a body, -1 for one from which a tree grows.
  int linkOf(int body) const;
  /// @return The link of a joint, -1 for one that closes a loop or holds nothing.
  int linkOfJoint(std::size_t joint) const { return linkOfJoint_[joint]; }
  /// @return Whether joints hang together that do not all act on one body.
  bool isDeep() const { return isDeep_; }

 private:
  void grow(int root, const std::vector<std::vector<int>>& jointsAt);
  void add(int joint, int body, int parent);

  std::vector<JointBodies> joints_;
  std::vector<Link> links_;
  std::vector<int> linkOf_;
  std::vector<int> linkOfJoint_;
  std::vector<bool> isReached_;
  bool isDeep_ = false;
};

/// @return Whether all joints act on one body, such as a robot's chassis.
bool haveOneHub(std::span<const JointBodies> joints);

/// A cache of trees, so that an island that keeps its joints finds its trees again.
class JointTrees {
 public:
  const JointTree& find(std::span<const JointBodies> joints);

 private:
  static constexpr std::size_t kKept = 64;
  /// By a hash of the joints.
  std::array<JointTree, kKept> trees_;
};

}  // namespace pongsim::physics
