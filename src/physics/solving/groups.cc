#include "physics/solving/groups.hh"

#include <algorithm>
#include <numeric>

namespace pongsim::physics {

void Groups::form(std::size_t bodies, std::span<const Ends> touches, std::span<const Ends> joints) {
  parents_.resize(bodies);
  std::iota(parents_.begin(), parents_.end(), 0U);
  for (const Ends& ends : touches) unite(ends);
  for (const Ends& ends : joints) unite(ends);
  number();

  for (const Ends& ends : touches) ++countsOf(ends, starts_).touches;
  for (const Ends& ends : joints) ++countsOf(ends, starts_).joints;
  sumUp();

  next_ = starts_;
  bodies_.resize(bodies);
  touches_.resize(touches.size());
  joints_.resize(joints.size());
  for (std::uint32_t body = 0; body < bodies; ++body) bodies_[next_[parents_[body]].bodies++] = body;
  for (std::uint32_t i = 0; i < touches.size(); ++i) touches_[countsOf(touches[i], next_).touches++] = i;
  for (std::uint32_t i = 0; i < joints.size(); ++i) joints_[countsOf(joints[i], next_).joints++] = i;
}

std::span<const std::uint32_t> Groups::bodies(std::size_t group) const {
  return std::span(bodies_).subspan(starts_[group].bodies, starts_[group + 1].bodies - starts_[group].bodies);
}

std::span<const std::uint32_t> Groups::touches(std::size_t group) const {
  return std::span(touches_).subspan(starts_[group].touches, starts_[group + 1].touches - starts_[group].touches);
}

std::span<const std::uint32_t> Groups::joints(std::size_t group) const {
  return std::span(joints_).subspan(starts_[group].joints, starts_[group + 1].joints - starts_[group].joints);
}

std::uint32_t Groups::rootOf(std::uint32_t body) {
  while (parents_[body] != body) {
    parents_[body] = parents_[parents_[body]];
    body = parents_[body];
  }
  return body;
}

void Groups::unite(const Ends& ends) {
  if (ends.first == kNoMember || ends.second == kNoMember) return;
  const std::uint32_t rootA = rootOf(static_cast<std::uint32_t>(ends.first));
  const std::uint32_t rootB = rootOf(static_cast<std::uint32_t>(ends.second));
  parents_[std::max(rootA, rootB)] = std::min(rootA, rootB);
}

// Parents stand before, and so have the number of their group in place of their parent when it is asked for.
void Groups::number() {
  starts_.clear();
  for (std::uint32_t body = 0; body < parents_.size(); ++body) {
    const bool isRoot = parents_[body] == body;
    if (isRoot) starts_.emplace_back();
    parents_[body] = isRoot ? static_cast<std::uint32_t>(starts_.size() - 1) : parents_[parents_[body]];
    ++starts_[parents_[body]].bodies;
  }
}

// of whichever of the two forces move
Groups::Counts& Groups::countsOf(const Ends& ends, std::vector<Counts>& counts) {
  return counts[parents_[static_cast<std::size_t>(ends.first != kNoMember ? ends.first : ends.second)]];
}

// from how many to where they begin
void Groups::sumUp() {
  starts_.emplace_back();
  Counts sum;
  for (Counts& counts : starts_) {
    const Counts count = std::exchange(counts, sum);
    sum = {sum.bodies + count.bodies, sum.touches + count.touches, sum.joints + count.joints};
  }
}

}  // namespace pongsim::physics
