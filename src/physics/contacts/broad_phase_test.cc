#include "physics/contacts/broad_phase.hh"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace pongsim::physics {
namespace {

/// Cubes of 1 m, known by where they are along x.
struct Row {
  BroadPhase broadPhase;
  btBroadphaseProxy& add(double x, bool forcesMove = true) {
    const int number = static_cast<int>(proxies.size()) + 1;
    proxies.push_back(&broadPhase.add(low(x), high(x), nullptr, forcesMove, number));
    return *proxies.back();
  }
  ~Row() {
    for (btBroadphaseProxy* proxy : proxies) broadPhase.destroyProxy(proxy, nullptr);
  }
  bool isPair(btBroadphaseProxy& a, btBroadphaseProxy& b) {
    return broadPhase.getOverlappingPairCache()->findPair(&a, &b) != nullptr;
  }
  static btVector3 low(double x) { return {x, 0, 0}; }
  static btVector3 high(double x) { return {x + 1, 1, 1}; }
  std::vector<btBroadphaseProxy*> proxies;
};

TEST(BroadPhase, FindsWhatIsNearAsItComes) {
  Row row;
  btBroadphaseProxy& a = row.add(0);
  btBroadphaseProxy& b = row.add(0.5);
  btBroadphaseProxy& wall = row.add(0.7, false);
  btBroadphaseProxy& far = row.add(3);
  EXPECT_TRUE(row.isPair(a, b));
  EXPECT_TRUE(row.isPair(a, wall));
  EXPECT_FALSE(row.isPair(a, far));
}

TEST(BroadPhase, FindsWhatIsNearWhenItLeavesItsBox) {
  Row row;
  btBroadphaseProxy& wall = row.add(0, false);
  btBroadphaseProxy& body = row.add(3);
  // the first box is as large as the body
  EXPECT_FALSE(BroadPhase::updateAabb(body, Row::low(2.9), Row::high(2.9)));
  row.broadPhase.fattenAabb(body, {-1.5, 0, 0});
  EXPECT_FALSE(row.isPair(wall, body));
  // there is room where it goes, and some behind
  EXPECT_TRUE(BroadPhase::updateAabb(body, Row::low(1.5), Row::high(1.5)));
  EXPECT_TRUE(BroadPhase::updateAabb(body, Row::low(2.94), Row::high(2.94)));
  EXPECT_FALSE(BroadPhase::updateAabb(body, Row::low(3), Row::high(3)));
  EXPECT_FALSE(BroadPhase::updateAabb(body, Row::low(1.1), Row::high(1.1)));
  row.broadPhase.fattenAabb(body, {0, 0, 0});
  EXPECT_FALSE(row.isPair(wall, body));
  EXPECT_FALSE(BroadPhase::updateAabb(body, Row::low(1.01), Row::high(1.01)));
  row.broadPhase.fattenAabb(body, {0, 0, 0});
  EXPECT_TRUE(row.isPair(wall, body));
  // near, but with a centimetre between
  EXPECT_TRUE(BroadPhase::fatAabbsOverlap(wall, body));
  EXPECT_FALSE(BroadPhase::aabbsOverlap(wall, body));
}

TEST(BroadPhase, TellsOfThoseThatHaveParted) {
  Row row;
  btBroadphaseProxy& a = row.add(0);
  btBroadphaseProxy& b = row.add(0.5);
  EXPECT_TRUE(BroadPhase::aabbsOverlap(a, b));
  row.broadPhase.setAabb(&b, Row::low(5), Row::high(5), nullptr);
  EXPECT_FALSE(BroadPhase::aabbsOverlap(a, b));
  EXPECT_FALSE(BroadPhase::fatAabbsOverlap(a, b));
}

TEST(BroadPhase, SaysOnceThatPairsHaveCome) {
  Row row;
  btBroadphaseProxy& a = row.add(0);
  EXPECT_FALSE(row.broadPhase.takeNewPairs());
  row.add(0.5);
  EXPECT_TRUE(row.broadPhase.takeNewPairs());
  EXPECT_FALSE(row.broadPhase.takeNewPairs());
  row.broadPhase.setAabb(&a, Row::low(0.1), Row::high(0.1), nullptr);
  EXPECT_FALSE(row.broadPhase.takeNewPairs());
}

TEST(BroadPhase, RemovesThePairsOfSomeBodiesOrOfAll) {
  Row row;
  btBroadphaseProxy& a = row.add(0);
  btBroadphaseProxy& b = row.add(0.3);
  btBroadphaseProxy& c = row.add(0.6);
  btBroadphaseProxy& d = row.add(0.9);
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  row.broadPhase.removePairs([&](const btBroadphaseProxy& each) { return &each == &d || &each == &a; }, dispatcher);
  EXPECT_EQ(row.broadPhase.getOverlappingPairCache()->getNumOverlappingPairs(), 1);
  EXPECT_TRUE(row.isPair(b, c));
  row.broadPhase.findPairs(a);
  EXPECT_TRUE(row.isPair(a, b));
  EXPECT_TRUE(row.isPair(a, d));
  row.broadPhase.removePairs([](const btBroadphaseProxy&) { return true; }, dispatcher);
  EXPECT_EQ(row.broadPhase.getOverlappingPairCache()->getNumOverlappingPairs(), 0);
}

TEST(BroadPhase, RefusesPairsIfThereAreFarMoreThanBodies) {
  Row row;
  const auto pairs = [&] {
    return static_cast<std::size_t>(row.broadPhase.getOverlappingPairCache()->getNumOverlappingPairs());
  };
  for (int i = 0; i < 400; ++i) row.add(0);
  EXPECT_EQ(pairs(), 400U * 399 / 2);
  EXPECT_EQ(row.broadPhase.refusedPairs(), 0U);
  for (int i = 400; i < 1000; ++i) row.add(0);
  EXPECT_EQ(pairs() + row.broadPhase.refusedPairs(), 1000U * 999 / 2);
  EXPECT_LE(pairs(), row.broadPhase.mostPairs());
  EXPECT_LT(row.broadPhase.mostPairs(), 110'000U);
  // the ground holds all
  btBroadphaseProxy& ground = row.add(0, false);
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(row.isPair(*row.proxies[static_cast<std::size_t>(i)], ground)) << i;
}

TEST(BroadPhase, FindsRefusedPairsWhenThereIsRoom) {
  Row row;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  std::vector<btRigidBody*> all;
  for (int i = 0; i < 500; ++i) {
    bodies.push_back(std::make_unique<btRigidBody>(1, nullptr, nullptr));
    all.push_back(bodies.back().get());
    all.back()->setBroadphaseHandle(&row.add(0));
  }
  EXPECT_GT(row.broadPhase.refusedPairs(), 0U);
  row.broadPhase.findRefusedPairs(all);
  const auto isOld = [&](const btBroadphaseProxy& each) { return each.m_uniqueId <= 250; };
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  row.broadPhase.removePairs(isOld, dispatcher);
  for (std::size_t i = 0; i < 250; ++i) {
    const double x = 10 * static_cast<double>(i) + 10;
    row.broadPhase.setAabb(row.proxies[i], Row::low(x), Row::high(x), &dispatcher);
  }
  row.broadPhase.findRefusedPairs(all);
  EXPECT_EQ(row.broadPhase.getOverlappingPairCache()->getNumOverlappingPairs(), 250 * 249 / 2);
}

TEST(BroadPhase, PutsWhoseNumberIsSmallerFirst) {
  Row row;
  btBroadphaseProxy& a = row.add(5);
  btBroadphaseProxy& b = row.add(0);
  row.broadPhase.setAabb(&a, Row::low(0.5), Row::high(0.5), nullptr);
  const btBroadphasePair* pair = row.broadPhase.getOverlappingPairCache()->findPair(&b, &a);
  ASSERT_NE(pair, nullptr);
  EXPECT_EQ(pair->m_pProxy0, &a);
}

}  // namespace
}  // namespace pongsim::physics
