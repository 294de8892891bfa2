#include "physics/lcp/joint_order.hh"

#include <algorithm>
#include <cstdint>

namespace pongsim::physics {

namespace {

/// Numbers of joints, in ascending order.
using Set = std::vector<int>;

void insertInto(Set& set, int value) {
  const auto at = std::ranges::lower_bound(set, value);
  if (at == set.end() || *at != value) set.insert(at, value);
}

template <class Sets>
auto& setOf(Sets& sets, int number) {
  return sets[static_cast<std::size_t>(number)];
}

bool actsOn(const JointBodies& joint, int body) { return std::ranges::find(joint, body) != joint.end(); }

/// @return For each body the joints that act on it.
std::vector<Set> jointsAtBodies(std::span<const JointBodies> joints) {
  std::vector<Set> result;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    for (const int body : joints[i]) {
      if (body < 0) continue;
      if (static_cast<std::size_t>(body) >= result.size()) result.resize(static_cast<std::size_t>(body) + 1);
      insertInto(setOf(result, body), static_cast<int>(i));
    }
  }
  return result;
}

/// @return For each joint those that have a body in common with it.
std::vector<Set> neighbours(std::size_t count, const std::vector<Set>& jointsAt) {
  std::vector<Set> result(count);
  for (const Set& joints : jointsAt) {
    for (const int joint : joints) {
      for (const int other : joints) {
        if (other != joint) insertInto(setOf(result, joint), other);
      }
    }
  }
  return result;
}

/// Takes joints out one after the other. Those that are coupled with one that goes become neighbours of each other.
class Elimination {
 public:
  Elimination(std::span<const JointBodies> joints, const std::vector<Set>& jointsAt)
      : joints_(joints), coupled_(neighbours(joints.size(), jointsAt)), isTaken_(joints.size()) {
    for (const Set& atBody : jointsAt) leftAt_.push_back(static_cast<int>(atBody.size()));
  }

  void takeAll() {
    takeLeaves();
    takeLeastCoupled();
  }
  /// @return The joints as they were taken.
  const std::vector<int>& order() const { return order_; }
  /// @return Of each joint those that it was coupled with when it was taken.
  const std::vector<Set>& coupled() const { return coupled_; }

 private:
  /// Takes the joints of a leaf of a tree, until there are loops only: none of these makes new neighbours.
  void takeLeaves() {
    std::vector<int> leaves;
    for (std::size_t i = joints_.size(); i-- > 0;) {
      if (isLeaf(static_cast<int>(i))) leaves.push_back(static_cast<int>(i));
    }
    while (!leaves.empty()) {
      const int joint = leaves.back();
      leaves.pop_back();
      if (isTaken(joint)) continue;
      take(joint);
      for (const int other : setOf(coupled_, joint)) {
        if (isLeaf(other)) leaves.push_back(other);
      }
    }
  }

  /// Takes the joint with the fewest neighbours, until there is none.
  void takeLeastCoupled() {
    Set left;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (!isTaken_[i]) left.push_back(static_cast<int>(i));
    }
    while (!left.empty()) {
      const auto fewest =
          std::ranges::min_element(left, {}, [this](int joint) { return setOf(coupled_, joint).size(); });
      take(*fewest);
      left.erase(fewest);
    }
  }

  bool isTaken(int joint) const { return isTaken_[static_cast<std::size_t>(joint)]; }
  /// @return Whether others act on one of its bodies at most.
  bool isLeaf(int joint) const {
    return std::ranges::count_if(joints_[static_cast<std::size_t>(joint)], [this](int body) {
             return body >= 0 && leftAt_[static_cast<std::size_t>(body)] > 1;
           }) <= 1;
  }

  void take(int joint) {
    order_.push_back(joint);
    isTaken_[static_cast<std::size_t>(joint)] = true;
    for (const int body : joints_[static_cast<std::size_t>(joint)]) {
      if (body >= 0) --leftAt_[static_cast<std::size_t>(body)];
    }
    const Set& own = setOf(coupled_, joint);
    for (const int other : own) {
      Set& its = setOf(coupled_, other);
      its.erase(std::ranges::lower_bound(its, joint));
      for (const int third : own) {
        if (third != other) insertInto(its, third);
      }
    }
  }

  std::span<const JointBodies> joints_;
  std::vector<Set> coupled_;
  std::vector<bool> isTaken_;
  /// How many joints each body still has.
  std::vector<int> leftAt_;
  std::vector<int> order_;
};

/// @return The same joints, those of each subtree one after the other.
std::vector<int> inSubtrees(const std::vector<int>& order, const std::vector<Set>& later) {
  std::vector<int> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  // the parent of a joint is the first that is taken out after it and coupled with it
  std::vector<Set> children(order.size());
  std::vector<int> open;
  for (const int joint : order) {
    const Set& behind = later[static_cast<std::size_t>(joint)];
    const auto parent =
        std::ranges::min_element(behind, {}, [&place](int other) { return place[static_cast<std::size_t>(other)]; });
    if (parent == behind.end()) {
      open.push_back(joint);
    } else {
      setOf(children, *parent).push_back(joint);
    }
  }
  // parents first, then all of it backwards
  std::vector<int> result;
  while (!open.empty()) {
    const int joint = open.back();
    open.pop_back();
    result.push_back(joint);
    for (const int child : setOf(children, joint)) open.push_back(child);
  }
  std::ranges::reverse(result);
  return result;
}

std::size_t hashOf(std::span<const JointBodies> joints) {
  std::uint64_t hash = joints.size();
  for (const JointBodies& bodies : joints) {
    for (const int body : bodies) hash = (hash ^ static_cast<std::uint64_t>(body)) * 0x9e3779b97f4a7c15U;
  }
  return static_cast<std::size_t>(hash >> 32U);
}

}  // namespace

void JointOrder::find(std::span<const JointBodies> joints) {
  joints_.assign(joints.begin(), joints.end());
  const std::vector<Set> jointsAt = jointsAtBodies(joints);
  Elimination elimination(joints, jointsAt);
  elimination.takeAll();
  const std::vector<Set>& coupled = elimination.coupled();
  order_ = inSubtrees(elimination.order(), coupled);
  placeOf_.resize(joints.size());
  for (std::size_t place = 0; place < count(); ++place) {
    placeOf_[static_cast<std::size_t>(order_[place])] = static_cast<int>(place);
  }
  starts_.assign(1, 0);
  later_.clear();
  for (const int joint : order_) {
    for (const int other : setOf(coupled, joint)) later_.push_back(placeOf(other));
    std::sort(later_.begin() + static_cast<std::ptrdiff_t>(starts_.back()), later_.end());
    starts_.push_back(later_.size());
  }
  isDeep_ = false;
  // where all joints that hang together are coupled, each has all up to their root behind it
  int root = -1;
  for (int place = static_cast<int>(count()) - 1; place >= 0; --place) {
    if (later(place).empty()) root = place;
    if (static_cast<int>(later(place).size()) != root - place) isDeep_ = true;
  }
  firstAt_.clear();
  for (const Set& atBody : jointsAt) {
    int first = -1;
    for (const int joint : atBody) first = first < 0 ? placeOf(joint) : std::min(first, placeOf(joint));
    firstAt_.push_back(first);
  }
}

bool JointOrder::isOf(std::span<const JointBodies> joints) const { return std::ranges::equal(joints_, joints); }

std::span<const int> JointOrder::later(int place) const {
  const auto i = static_cast<std::size_t>(place);
  return std::span(later_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
}

int JointOrder::firstAt(int body) const {
  const auto i = static_cast<std::size_t>(body);
  return i < firstAt_.size() ? firstAt_[i] : -1;
}

bool haveOneHub(std::span<const JointBodies> joints) {
  if (joints.empty()) return true;
  return std::ranges::any_of(joints.front(), [joints](int body) {
    return body >= 0 && std::ranges::all_of(joints, [body](const JointBodies& each) { return actsOn(each, body); });
  });
}

const JointOrder& JointOrders::find(std::span<const JointBodies> joints) {
  JointOrder& order = orders_[hashOf(joints) % kKept];
  if (!order.isOf(joints)) order.find(joints);
  return order;
}

}  // namespace pongsim::physics
