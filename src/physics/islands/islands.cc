#include "physics/islands/islands.hh"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

namespace pongsim::physics {

void Islands::form(std::size_t bodies, std::span<const Ends> touches, std::span<const Ends> joints) {
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

std::span<const std::uint32_t> Islands::bodies(std::size_t island) const {
  return std::span(bodies_).subspan(starts_[island].bodies, starts_[island + 1].bodies - starts_[island].bodies);
}

std::span<const std::uint32_t> Islands::touches(std::size_t island) const {
  return std::span(touches_).subspan(starts_[island].touches, starts_[island + 1].touches - starts_[island].touches);
}

std::span<const std::uint32_t> Islands::joints(std::size_t island) const {
  return std::span(joints_).subspan(starts_[island].joints, starts_[island + 1].joints - starts_[island].joints);
}

std::uint32_t Islands::rootOf(std::uint32_t body) {
  while (parents_[body] != body) {
    parents_[body] = parents_[parents_[body]];
    body = parents_[body];
  }
  return body;
}

void Islands::unite(const Ends& ends) {
  unite(ends.first, ends.second);
  if (ends.third == kNoMember) return;
  unite(ends.first, ends.third);
  unite(ends.second, ends.third);
}

void Islands::unite(int a, int b) {
  if (a == kNoMember || b == kNoMember) return;
  assert(static_cast<std::size_t>(std::max(a, b)) < parents_.size());
  const std::uint32_t rootA = rootOf(static_cast<std::uint32_t>(a));
  const std::uint32_t rootB = rootOf(static_cast<std::uint32_t>(b));
  parents_[std::max(rootA, rootB)] = std::min(rootA, rootB);
}

// replaces each body's parent by its island: parents come before, so theirs is already known
void Islands::number() {
  starts_.clear();
  for (std::uint32_t body = 0; body < parents_.size(); ++body) {
    const bool isRoot = parents_[body] == body;
    if (isRoot) starts_.emplace_back();
    parents_[body] = isRoot ? static_cast<std::uint32_t>(starts_.size() - 1) : parents_[parents_[body]];
    ++starts_[parents_[body]].bodies;
  }
}

// all bodies of a touch or joint that move are in the same island
Islands::Counts& Islands::countsOf(const Ends& ends, std::vector<Counts>& counts) {
  const int member = ends.first != kNoMember ? ends.first : ends.second != kNoMember ? ends.second : ends.third;
  assert(member != kNoMember);
  return counts[parents_[static_cast<std::size_t>(member)]];
}

// from the numbers of members to where they begin
void Islands::sumUp() {
  starts_.emplace_back();
  Counts sum;
  for (Counts& counts : starts_) {
    const Counts count = std::exchange(counts, sum);
    sum = {sum.bodies + count.bodies, sum.touches + count.touches, sum.joints + count.joints};
  }
}

}  // namespace pongsim::physics
