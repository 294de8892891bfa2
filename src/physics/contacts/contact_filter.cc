#include "physics/contacts/contact_filter.hh"

#include <BulletCollision/CollisionDispatch/btCollisionObject.h>

#include <algorithm>
#include <cassert>

#include "physics/body.hh"

namespace pongsim::physics {

namespace {

bool collidesWithOwnModel(const world::LinkRecord& link, const description::Model& model) {
  return link.description->selfCollide.value_or(model.selfCollide);
}

world::Slot slotOf(const btBroadphaseProxy* proxy) {
  const int index = static_cast<const btCollisionObject*>(proxy->m_clientObject)->getUserIndex();
  return static_cast<world::Slot>(index);
}

}  // namespace

ContactFilter::ContactFilter(const world::Entities& entities) : entities_(entities) {
  update(entities.joints().size());
}

void ContactFilter::update(std::size_t joints) {
  jointed_.clear();
  known_ = 0;
  grow(joints);
}

void ContactFilter::grow(std::size_t joints) {
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

bool ContactFilter::mayTouch(world::Slot a, world::Slot b) const {
  assert(a < entities_.links().size() && b < entities_.links().size());
  const world::LinkRecord& linkA = entities_.links()[a];
  const world::LinkRecord& linkB = entities_.links()[b];
  if (!isMoving(linkA) && !isMoving(linkB)) return false;
  if (linkA.model == linkB.model) {
    const description::Model& model = *entities_.models()[linkA.model].description;
    if (!collidesWithOwnModel(linkA, model) || !collidesWithOwnModel(linkB, model)) return false;
  }
  return !std::binary_search(jointed_.begin(), jointed_.end(), std::pair<world::Slot, world::Slot>(std::minmax(a, b)));
}

bool ContactFilter::needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const {
  return mayTouch(slotOf(a), slotOf(b));
}

}  // namespace pongsim::physics
