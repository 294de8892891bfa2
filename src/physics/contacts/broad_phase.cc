#include "physics/contacts/broad_phase.hh"

#include <LinearMath/btAabbUtil2.h>

#include <new>

namespace pongsim::physics {

namespace {

/// Margin of a fat box on all sides [m].
constexpr double kFatMargin = 0.05;
/// Limits of the number of pairs. A cube in a grid of cubes has 26 neighbours, so 13 pairs.
constexpr std::size_t kFewPairs = 80'000;
constexpr std::size_t kPairsOfABody = 24;

/// Adds a pair for each body whose box overlaps the box of a given body.
class PairFinder final : public btDbvt::ICollide {
 public:
  /// @param most Of more pairs, those of two moving bodies are refused; of twice as many, all.
  PairFinder(btOverlappingPairCache& pairs, btDbvtProxy& proxy, std::size_t most)
      : pairs_(pairs), proxy_(proxy), most_(most) {}

  void Process(const btDbvtNode* node) override {
    auto* other = static_cast<btDbvtProxy*>(node->data);
    if (other == &proxy_) return;
    // the smaller number first, whichever has moved
    const bool isFirst = proxy_.m_uniqueId < other->m_uniqueId;
    btBroadphaseProxy *const first = isFirst ? &proxy_ : other, *const second = isFirst ? other : &proxy_;
    if (isFull(*other) && pairs_.needsBroadphaseCollision(first, second) && pairs_.findPair(first, second) == nullptr) {
      ++refused;
    } else {
      pairs_.addOverlappingPair(first, second);
    }
  }

  std::size_t refused = 0;

 private:
  bool isFull(const btDbvtProxy& other) const {
    const bool isOneFixed = proxy_.stage == BroadPhase::STAGECOUNT || other.stage == BroadPhase::STAGECOUNT;
    return static_cast<std::size_t>(pairs_.getNumOverlappingPairs()) >= (isOneFixed ? 2 * most_ : most_);
  }

  btOverlappingPairCache& pairs_;
  btDbvtProxy& proxy_;
  const std::size_t most_;
};

}  // namespace

// Bullet numbers its trees by stages, of which only the first and the last are used here
btDbvt& BroadPhase::treeOf(const btDbvtProxy& proxy) {
  return m_sets[proxy.stage == STAGECOUNT ? FIXED_SET : DYNAMIC_SET];
}

btBroadphaseProxy& BroadPhase::add(const btVector3& lowest, const btVector3& highest, btCollisionObject* object,
                                   bool forcesMove, int number) {
  void* const place = btAlignedAlloc(sizeof(btDbvtProxy), alignof(btDbvtProxy));
  const int group = forcesMove ? btBroadphaseProxy::DefaultFilter : btBroadphaseProxy::StaticFilter;
  const int mask = forcesMove ? btBroadphaseProxy::AllFilter : btBroadphaseProxy::AllFilter ^ group;
  auto* proxy = new (place) btDbvtProxy(lowest, highest, object, group, mask);
  proxy->m_uniqueId = number;
  proxy->stage = forcesMove ? 0 : STAGECOUNT;
  btDbvt& tree = treeOf(*proxy);
  proxy->leaf = tree.insert(btDbvtVolume::FromMM(lowest, highest), proxy);
  balance_.keepShallow(tree, *proxy->leaf);
  refused_ += findPairsNow(*proxy);
  return *proxy;
}

void BroadPhase::destroyProxy(btBroadphaseProxy* absolute, btDispatcher* /*dispatcher*/) {
  auto* proxy = static_cast<btDbvtProxy*>(absolute);
  treeOf(*proxy).remove(proxy->leaf);
  btAlignedFree(proxy);
}

void BroadPhase::setAabb(btBroadphaseProxy* absolute, const btVector3& lowest, const btVector3& highest,
                         btDispatcher* /*dispatcher*/) {
  auto& proxy = static_cast<btDbvtProxy&>(*absolute);
  proxy.m_aabbMin = lowest;
  proxy.m_aabbMax = highest;
  put(proxy, btDbvtVolume::FromMM(lowest, highest));
}

bool BroadPhase::updateAabb(btBroadphaseProxy& proxy, const btVector3& lowest, const btVector3& highest) {
  proxy.m_aabbMin = lowest;
  proxy.m_aabbMax = highest;
  return static_cast<btDbvtProxy&>(proxy).leaf->volume.Contain(btDbvtVolume::FromMM(lowest, highest));
}

void BroadPhase::fattenAabb(btBroadphaseProxy& absolute, const btVector3& motion) {
  auto& proxy = static_cast<btDbvtProxy&>(absolute);
  btDbvtVolume volume = btDbvtVolume::FromMM(proxy.m_aabbMin, proxy.m_aabbMax);
  volume.Expand(btVector3(kFatMargin, kFatMargin, kFatMargin));
  volume.SignedExpand(motion);
  put(proxy, volume);
}

void BroadPhase::put(btDbvtProxy& proxy, btDbvtVolume volume) {
  btDbvt& tree = treeOf(proxy);
  tree.update(proxy.leaf, volume);
  balance_.keepShallow(tree, *proxy.leaf);
  findPairs(proxy);
}

void BroadPhase::findPairs(btBroadphaseProxy& proxy) { refusedAgain_ += findPairsNow(proxy); }

std::size_t BroadPhase::findPairsNow(btBroadphaseProxy& absolute) {
  auto& proxy = static_cast<btDbvtProxy&>(absolute);
  const int before = m_paircache->getNumOverlappingPairs();
  PairFinder finder(*m_paircache, proxy, mostPairs());
  for (const btDbvt& set : m_sets) set.collideTV(set.m_root, proxy.leaf->volume, finder);
  haveNewPairs_ = haveNewPairs_ || m_paircache->getNumOverlappingPairs() != before;
  isOneMissing_ = isOneMissing_ || finder.refused > 0;
  return finder.refused;
}

std::size_t BroadPhase::mostPairs() const {
  return kFewPairs + kPairsOfABody * static_cast<std::size_t>(m_sets[DYNAMIC_SET].m_leaves);
}

void BroadPhase::findRefusedPairs(std::span<btRigidBody* const> bodies) {
  // not for each pair that goes
  if (!isOneMissing_ || 4 * static_cast<std::size_t>(m_paircache->getNumOverlappingPairs()) > 3 * mostPairs()) return;
  isOneMissing_ = false;
  for (btRigidBody* body : bodies) {
    if (body->getBroadphaseHandle() != nullptr) findPairs(*body->getBroadphaseHandle());
  }
}

bool BroadPhase::fatAabbsOverlap(const btBroadphaseProxy& a, const btBroadphaseProxy& b) {
  return Intersect(static_cast<const btDbvtProxy&>(a).leaf->volume, static_cast<const btDbvtProxy&>(b).leaf->volume);
}

}  // namespace pongsim::physics
