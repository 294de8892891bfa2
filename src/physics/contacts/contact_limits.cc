#include "physics/contacts/contact_limits.hh"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>

#include "physics/contacts/dispatcher.hh"
#include "physics/contacts/friction.hh"

namespace pongsim::physics {

namespace {

/// @return Number of the collision whose part that is.
std::uint32_t collisionOf(std::uint64_t part) {
  constexpr std::uint32_t kWhole = 0xffffffffU;
  const auto number = static_cast<std::uint32_t>(part);
  return number == kWhole ? kWhole : static_cast<std::uint32_t>(collisionOfPart(static_cast<int>(number)));
}

bool areOfSameCollisions(const Touch& a, const Touch& b) {
  return a.links == b.links && collisionOf(a.parts) == collisionOf(b.parts) &&
         collisionOf(a.parts >> 32U) == collisionOf(b.parts >> 32U);
}

}  // namespace

void limitContacts(btPersistentManifold& manifold, long long otherwise) {
  const long long most = mostContacts(manifold, otherwise);
  while (most >= 0 && manifold.getNumContacts() > most) {
    int shallowest = 0;
    for (int i = 1; i < manifold.getNumContacts(); ++i) {
      if (manifold.getContactPoint(i).getDistance() > manifold.getContactPoint(shallowest).getDistance())
        shallowest = i;
    }
    manifold.removeContactPoint(shallowest);
  }
}

// Keeps the deepest point, and then repeatedly the one that is farthest from those kept, so that they support the body.
std::size_t PieceLimits::limit(std::span<Touch> touches, long long otherwise) {
  assert(std::ranges::is_sorted(touches, std::less<>()));
  bool isOneEmpty = false;
  for (auto first = touches.begin(); first != touches.end();) {
    const auto end =
        std::find_if(first + 1, touches.end(), [&](const Touch& touch) { return !areOfSameCollisions(*first, touch); });
    const long long most = end - first > 1 ? mostContacts(*first->manifold, otherwise) : -1;
    if (most >= 0) isOneEmpty |= keepSpread(std::span(first, end), static_cast<std::size_t>(most));
    first = end;
  }
  if (!isOneEmpty) return touches.size();
  const auto isEmpty = [](const Touch& touch) { return touch.manifold->getNumContacts() == 0; };
  return static_cast<std::size_t>(std::remove_if(touches.begin(), touches.end(), isEmpty) - touches.begin());
}

bool PieceLimits::keepSpread(std::span<const Touch> touches, std::size_t most) {
  points_.clear();
  for (const Touch& touch : touches) {
    for (int i = 0; i < touch.manifold->getNumContacts(); ++i) {
      points_.push_back({touch.manifold, i, std::numeric_limits<double>::infinity(), false});
    }
  }
  if (points_.size() <= most) return false;
  const auto pointOf = [](const Point& point) -> const btManifoldPoint& {
    return point.manifold->getContactPoint(point.index);
  };
  auto next = std::ranges::min_element(points_, {}, [&](const Point& p) { return pointOf(p).getDistance(); });
  for (std::size_t kept = 0; kept < most; ++kept) {
    next->isKept = true;
    const btVector3 place = pointOf(*next).getPositionWorldOnB();
    for (Point& point : points_) {
      const double distance = (pointOf(point).getPositionWorldOnB() - place).length2();
      point.distance = point.isKept ? -1 : std::min(point.distance, distance);
    }
    next = std::ranges::max_element(points_, {}, &Point::distance);
  }
  // backwards, because the last point of a manifold takes the place of a removed one
  bool isOneEmpty = false;
  for (auto point = points_.rbegin(); point != points_.rend(); ++point) {
    if (!point->isKept) point->manifold->removeContactPoint(point->index);
    isOneEmpty |= point->manifold->getNumContacts() == 0;
  }
  return isOneEmpty;
}

}  // namespace pongsim::physics
