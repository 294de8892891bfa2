#include "physics/contacts/contact_filter.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <algorithm>
#include <cassert>

#include "physics/body.hh"

namespace pongsim::physics {

namespace {

world::Slot slotOf(const btBroadphaseProxy* proxy) {
  const int index = static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex();
  return static_cast<world::Slot>(index);
}

}  // namespace

ContactFilter::ContactFilter(const world::Entities& entities) : entities_(entities) {
  update(entities.links().size(), entities.joints().size());
}

void ContactFilter::update(std::size_t links, std::size_t joints) {
  jointed_.clear();
  known_ = 0;
  grow(links, joints);
}

void ContactFilter::grow(std::size_t links, std::size_t joints) {
  findSkeletons(links, joints);
  const auto sorted = static_cast<std::ptrdiff_t>(jointed_.size());
  for (; known_ < joints; ++known_) {
    const world::JointRecord& joint = entities_.joints()[known_];
    if (joint.parentLink == world::kNoSlot || joint.childLink == world::kNoSlot) continue;
    jointed_.push_back(std::minmax(joint.parentLink, joint.childLink));
  }
  const auto middle = jointed_.begin() + sorted;
  std::sort(middle, jointed_.end());
  std::inplace_merge(jointed_.begin(), middle, jointed_.end());
}

void ContactFilter::findSkeletons(std::size_t links, std::size_t joints) {
  parents_.assign(links, world::kNoSlot);
  for (world::Slot slot = 0; slot < joints; ++slot) {
    const world::JointRecord& joint = entities_.joints()[slot];
    // those made at run time, and those of the world, have no model
    if (joint.model == world::kNoSlot || joint.parentLink == world::kNoSlot || joint.childLink == world::kNoSlot)
      continue;
    // the first joint holds a link that closes a loop
    if (world::Slot& parent = parents_[joint.childLink]; parent == world::kNoSlot) parent = joint.parentLink;
  }
  skeletons_.assign(links, world::kNoSlot);
  for (world::Slot link = 0; link < links; ++link) {
    const world::Slot own = entities_.links()[link].model;
    world::Slot top = link;
    std::size_t steps = 0;
    // what was passed on the way up counts as found, which ends the way around a ring
    for (; skeletons_[top] == world::kNoSlot && parents_[top] != world::kNoSlot; top = parents_[top], ++steps) {
      skeletons_[top] = own;
    }
    if (skeletons_[top] == world::kNoSlot) skeletons_[top] = entities_.links()[top].model;
    const world::Slot found = skeletons_[top];
    for (world::Slot passed = link; steps > 0; passed = parents_[passed], --steps) skeletons_[passed] = found;
  }
}

bool ContactFilter::mayTouch(world::Slot a, world::Slot b) const {
  assert(a < skeletons_.size() && b < skeletons_.size());
  const world::LinkRecord& linkA = entities_.links()[a];
  const world::LinkRecord& linkB = entities_.links()[b];
  if (!isMoving(linkA) && !isMoving(linkB)) return false;
  if (skeletons_[a] == skeletons_[b] && !entities_.models()[skeletons_[a]].description->selfCollide) return false;
  return !std::binary_search(jointed_.begin(), jointed_.end(), std::pair<world::Slot, world::Slot>(std::minmax(a, b)));
}

bool ContactFilter::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
  return mayTouch(slotOf(a), slotOf(b));
}

}  // namespace pongsim::physics
