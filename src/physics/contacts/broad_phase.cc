#include "physics/contacts/broad_phase.hh"

#include <LinearMath/btAabbUtil2.h>

#include <new>

namespace pongsim::physics {

namespace {

/// Margin of a fat box on all sides [m].
constexpr double kFatMargin = 0.05;

/// Adds a pair for each body whose box overlaps the box of a given body.
class PairFinder final : public btDbvt::ICollide {
 public:
  PairFinder(btOverlappingPairCache& pairs, btDbvtProxy& proxy) : pairs_(pairs), proxy_(proxy) {}

  void Process(const btDbvtNode* node) override {
    auto* other = static_cast<btDbvtProxy*>(node->data);
    if (other == &proxy_) return;
    // the smaller number first, whichever has moved
    const bool isFirst = proxy_.m_uniqueId < other->m_uniqueId;
    pairs_.addOverlappingPair(isFirst ? &proxy_ : other, isFirst ? other : &proxy_);
  }

 private:
  btOverlappingPairCache& pairs_;
  btDbvtProxy& proxy_;
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
  findPairs(*proxy);
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

void BroadPhase::findPairs(btBroadphaseProxy& absolute) {
  auto& proxy = static_cast<btDbvtProxy&>(absolute);
  const int before = m_paircache->getNumOverlappingPairs();
  PairFinder finder(*m_paircache, proxy);
  for (const btDbvt& set : m_sets) set.collideTV(set.m_root, proxy.leaf->volume, finder);
  haveNewPairs_ = haveNewPairs_ || m_paircache->getNumOverlappingPairs() != before;
}

bool BroadPhase::fatAabbsOverlap(const btBroadphaseProxy& a, const btBroadphaseProxy& b) {
  return Intersect(static_cast<const btDbvtProxy&>(a).leaf->volume, static_cast<const btDbvtProxy&>(b).leaf->volume);
}

}  // namespace pongsim::physics
