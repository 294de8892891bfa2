#include "physics/solving/joint_tree.hh"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pongsim::physics {

namespace {

std::array<int, 3> bodiesOf(const JointBodies& joint) { return {joint.parent, joint.child, joint.reference}; }

bool actsOn(const JointBodies& joint, int body) {
  return joint.parent == body || joint.child == body || joint.reference == body;
}

template <class Values>
decltype(auto) valueOf(Values& values, int number) {
  return values[static_cast<std::size_t>(number)];
}

/// @return The joints that hang together, group by group.
std::vector<std::vector<JointBodies>> groupsOf(std::span<const JointBodies> joints, std::size_t bodies) {
  std::vector<int> group(bodies);
  for (std::size_t i = 0; i < bodies; ++i) group[i] = static_cast<int>(i);
  for (const JointBodies& joint : joints) {
    int first = -1;
    for (const int body : bodiesOf(joint)) {
      if (body < 0) continue;
      if (first < 0) first = valueOf(group, body);
      std::ranges::replace(group, int{valueOf(group, body)}, first);
    }
  }
  std::vector<std::vector<JointBodies>> result(bodies);
  for (const JointBodies& joint : joints) {
    for (const int body : bodiesOf(joint)) {
      if (body < 0) continue;
      valueOf(result, valueOf(group, body)).push_back(joint);
      break;
    }
  }
  return result;
}

std::size_t hashOf(std::span<const JointBodies> joints) {
  std::uint64_t hash = joints.size();
  for (const JointBodies& joint : joints) {
    for (const int body : bodiesOf(joint)) hash = (hash ^ static_cast<std::uint64_t>(body)) * 0x9e3779b97f4a7c15U;
  }
  return static_cast<std::size_t>(hash >> 32U);
}

}  // namespace

void JointTree::find(std::span<const JointBodies> joints) {
  joints_.assign(joints.begin(), joints.end());
  links_.clear();
  linkOfJoint_.assign(joints.size(), -1);
  int last = -1;
  for (const JointBodies& joint : joints) last = std::max({last, joint.parent, joint.child, joint.reference});
  const auto bodies = static_cast<std::size_t>(last + 1);
  linkOf_.assign(bodies, -1);
  isReached_.assign(bodies, false);
  std::vector<std::vector<int>> jointsAt(bodies);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!joints[i].holds) continue;
    for (const int body : {joints[i].parent, joints[i].child}) {
      if (body >= 0) valueOf(jointsAt, body).push_back(static_cast<int>(i));
    }
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto [parent, child, reference, holds] = joints[i];
    const int held = parent < 0 ? child : parent;
    if (!holds || (parent >= 0 && child >= 0) || valueOf(isReached_, held)) continue;
    add(static_cast<int>(i), held, -1);
    grow(held, jointsAt);
  }
  for (int body = 0; body <= last; ++body) {
    if (!valueOf(isReached_, body)) grow(body, jointsAt);
  }
  isDeep_ = !std::ranges::all_of(groupsOf(joints, bodies), haveOneHub);
}

/// Adds all that joints hold to a body.
void JointTree::grow(int root, const std::vector<std::vector<int>>& jointsAt) {
  valueOf(isReached_, root) = true;
  std::vector<int> open = {root};
  for (std::size_t i = 0; i < open.size(); ++i) {
    const int body = open[i];
    for (const int number : valueOf(jointsAt, body)) {
      const JointBodies& joint = valueOf(joints_, number);
      const int other = joint.parent == body ? joint.child : joint.parent;
      if (other < 0 || valueOf(isReached_, other)) continue;
      add(number, other, body);
      open.push_back(other);
    }
  }
}

void JointTree::add(int joint, int body, int parent) {
  valueOf(linkOf_, body) = valueOf(linkOfJoint_, joint) = static_cast<int>(links_.size());
  links_.push_back({joint, body, parent, valueOf(joints_, joint).parent == body});
  valueOf(isReached_, body) = true;
}

bool JointTree::isOf(std::span<const JointBodies> joints) const { return std::ranges::equal(joints_, joints); }

int JointTree::linkOf(int body) const {
  const auto i = static_cast<std::size_t>(body);
  return i < linkOf_.size() ? linkOf_[i] : -1;
}

bool haveOneHub(std::span<const JointBodies> joints) {
  if (joints.empty()) return true;
  return std::ranges::any_of(bodiesOf(joints.front()), [joints](int body) {
    return body >= 0 && std::ranges::all_of(joints, [body](const JointBodies& each) { return actsOn(each, body); });
  });
}

const JointTree& JointTrees::find(std::span<const JointBodies> joints) {
  JointTree& tree = trees_[hashOf(joints) % kKept];
  if (!tree.isOf(joints)) tree.find(joints);
  return tree;
}

}  // namespace pongsim::physics
