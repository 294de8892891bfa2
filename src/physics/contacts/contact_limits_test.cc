#include "physics/contacts/contact_limits.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>
#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

#include "physics/contacts/dispatcher.hh"

namespace pongsim::physics {
namespace {

/// Points of contact at x = 0, 1, ... of two bodies that are not ours, so that no surface says how many there may be.
struct Manifold : btPersistentManifold {
  explicit Manifold(std::initializer_list<double> distances, double from = 0)
      : btPersistentManifold(&a, &b, 0, 0.02, 0.02) {
    for (const double distance : distances) {
      const btVector3 place(from + getNumContacts(), 0, 0);
      btManifoldPoint point(place, place, btVector3(0, 0, 1), distance);
      point.m_positionWorldOnB = place;
      addManifoldPoint(point);
    }
  }
  std::vector<double> distances() const {
    std::vector<double> all;
    for (int i = 0; i < getNumContacts(); ++i) all.push_back(getContactPoint(i).getDistance());
    return all;
  }
  btCollisionObject a, b;
};

TEST(ContactLimits, LeaveTheDeepestPoints) {
  Manifold manifold({-0.001, -0.003, -0.002});
  limitContacts(manifold, 2);
  ASSERT_EQ(manifold.getNumContacts(), 2);
  for (const double distance : manifold.distances()) EXPECT_LE(distance, -0.002);
  limitContacts(manifold, 0);
  EXPECT_EQ(manifold.getNumContacts(), 0);
}

TEST(ContactLimits, LeaveAllWhereThereIsNone) {
  Manifold manifold({-0.001, -0.003, -0.002});
  limitContacts(manifold, -1);
  limitContacts(manifold, 3);
  EXPECT_EQ(manifold.getNumContacts(), 3);
}

Touch pieceOf(Manifold& manifold, int collision, int piece) {
  return {7, static_cast<std::uint64_t>(partNumber(collision, piece)), &manifold, 0, kNoMember};
}

TEST(PieceLimits, KeepOfTwoCollisionsPointsThatAreFarFromEachOther) {
  Manifold first({-0.001}), second({-0.003}, 1), third({-0.002}, 5), ofAnother({-0.001}, 2);
  std::vector<Touch> touches = {pieceOf(first, 0, 0), pieceOf(second, 0, 1), pieceOf(third, 0, 2),
                                pieceOf(ofAnother, 1, 0)};
  PieceLimits limits;
  ASSERT_EQ(limits.limit(touches, 2), 3U);
  EXPECT_EQ(touches[0].manifold, &second);
  EXPECT_EQ(touches[1].manifold, &third);
  EXPECT_EQ(touches[2].manifold, &ofAnother);
  EXPECT_EQ(first.getNumContacts(), 0);
}

TEST(PieceLimits, LeaveAllWhereThereAreFewEnough) {
  Manifold first({-0.001}), second({-0.003}, 1);
  std::vector<Touch> touches = {pieceOf(first, 0, 0), pieceOf(second, 0, 1)};
  PieceLimits limits;
  EXPECT_EQ(limits.limit(touches, 2), 2U);
  EXPECT_EQ(limits.limit(touches, -1), 2U);
  EXPECT_EQ(first.getNumContacts() + second.getNumContacts(), 2);
}

}  // namespace
}  // namespace pongsim::physics
