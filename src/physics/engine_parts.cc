#include "physics/engine_parts.hh"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "description/limits.hh"
#include "physics/contacts/manifold_state.hh"
#include "physics/convert.hh"

namespace pongsim::physics {

Engine::Parts::~Parts() {
  scratch.bodies.clear();
  for (const auto& body : bodies) {
    if (body->rigid().getBroadphaseHandle() != nullptr) scratch.bodies.push_back(&body->rigid());
  }
  stepper.collisions().remove(scratch.bodies);
}

void Engine::Parts::grow() {
  prepareHulls();
  makeRoom();
  const world::Slot firstLink = bodies.size(), firstJoint = joints.size();
  const std::size_t movingBefore = moving.size();
  try {
    for (world::Slot link = firstLink; link < entities.links().size(); ++link) {
      bodies.push_back(arena.make<Body>(entities, link, gravity, hulls, shared));
    }
    // before bodies are added, because their pairs are filtered then
    filter.grow(entities.links().size(), entities.joints().size());
    for (world::Slot link = firstLink; link < bodies.size(); ++link) take(*bodies[link]);
    addJoints();
    renumberFrom(firstLink, firstJoint);
    frictionFrames.find(bodies, firstLink, entities);
  } catch (...) {
    shorten(firstLink, firstJoint, movingBefore);
    throw;
  }
  // last, because it discards contacts
  for (world::Slot slot = firstJoint; slot < joints.size(); ++slot) {
    stepper.collisions().separate(joints[slot]->parent(), joints[slot]->child());
  }
}

void Engine::Parts::makeRoom() {
  const auto reserve = [](auto& array, std::size_t count) {
    if (array.capacity() < count) array.reserve(std::max(count, 2 * array.capacity()));
  };
  reserve(scratch.freed, 2 * entities.joints().size());
  reserve(scratch.bodies, entities.links().size());
  reserve(scratch.joints, entities.joints().size());
  reserve(scratch.gone, entities.links().size());
}

void Engine::Parts::shorten(world::Slot links, world::Slot jointCount, std::size_t movingLinks) noexcept {
  frictionFrames.removeFrom(links);
  scratch.bodies.clear();
  for (world::Slot link = links; link < bodies.size(); ++link) {
    if (bodies[link]->rigid().getBroadphaseHandle() != nullptr) scratch.bodies.push_back(&bodies[link]->rigid());
  }
  stepper.collisions().remove(scratch.bodies);
  moving.resize(std::min(moving.size(), movingLinks));
  joints.erase(joints.begin() + static_cast<std::ptrdiff_t>(jointCount), joints.end());
  bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(links), bodies.end());
  renumberFrom(links, jointCount);
  filter.update(links, jointCount);
}

void Engine::Parts::take(Body& body) {
  if (entities.links()[body.link()].isSetAside) return;
  if (body.moves() || body.collides()) stepper.collisions().add(body.rigid(), static_cast<int>(body.id().value));
}

// all at once, because they are computed in parallel
void Engine::Parts::prepareHulls() {
  std::vector<HullRequest> requests;
  for (world::Slot link = bodies.size(); link < entities.links().size(); ++link) {
    const world::LinkRecord& record = entities.links()[link];
    for (const description::Collision& collision : record.description->collisions) {
      if (usesHulls(collision.geometry, isMoving(record))) requests.push_back(requestFor(collision.geometry));
    }
  }
  hulls.prepare(requests);
}

void Engine::Parts::addJoints() {
  const world::Slot first = joints.size();
  for (world::Slot slot = first; slot < entities.joints().size(); ++slot) {
    const world::JointRecord& record = entities.joints()[slot];
    const description::Joint& description = *record.description;
    joints.push_back(arena.make<Joint>(description, end(record.parentLink, description.X_ParentJoint),
                                       end(record.childLink, description.X_ChildJoint),
                                       end(record.referenceLink, description.X_ReferenceJoint)));
  }
  for (world::Slot slot = first; slot < joints.size(); ++slot) {
    const world::JointRecord& record = entities.joints()[slot];
    if (record.model == world::kNoSlot) continue;
    for (std::size_t i = 0; i < joints[slot]->axisCount(); ++i) {
      const std::optional<description::Mimic>& mimic = record.description->axes[i].mimic;
      const world::Slot leader = mimic ? entities.findJoint(record.model, mimic->joint) : world::kNoSlot;
      if (hasAxis(leader, mimic ? mimic->axis : 0)) joints[slot]->follow(i, *joints[leader], *mimic);
    }
  }
}

void Engine::Parts::remove(const world::Removal& removal) {
  std::vector<btRigidBody*>& freed = scratch.freed;
  freed.clear();
  for (const world::Slot slot : removal.joints) {
    freed.push_back(&joints[slot]->parent());
    freed.push_back(&joints[slot]->child());
  }
  takeOut(removal.links);
  frictionFrames.remove(removal.links);
  world::eraseSlots(joints, removal.joints);
  std::erase_if(keptTouches, [&](const KeptTouch& touch) {
    return std::ranges::any_of(removal.links, [&](world::Slot link) {
      return bodies[link]->id() == touch.linkA || bodies[link]->id() == touch.linkB;
    });
  });
  // removed bodies must live until their broad-phase handles have been checked below
  for (const world::Slot slot : removal.links) scratch.gone.push_back(std::move(bodies[slot]));
  world::eraseSlots(bodies, removal.links);
  renumberFrom(removal.links.empty() ? bodies.size() : removal.links.front(),
               removal.joints.empty() ? joints.size() : removal.joints.front());
  filter.update(bodies.size(), joints.size());
  std::erase_if(freed, [](const btRigidBody* body) { return body->getBroadphaseHandle() == nullptr; });
  std::ranges::sort(freed, {}, [this](const btRigidBody* body) { return bodyOf(*body).link(); });
  const auto repeated = std::ranges::unique(freed);
  freed.erase(repeated.begin(), repeated.end());
  for (btRigidBody* body : freed) stepper.collisions().findPairsOf(*body);
  scratch.gone.clear();
}

void Engine::Parts::takeOut(std::span<const world::Slot> links) {
  scratch.bodies.clear();
  for (const world::Slot link : links) {
    btRigidBody& rigid = bodies[link]->rigid();
    if (rigid.getBroadphaseHandle() != nullptr) scratch.bodies.push_back(&rigid);
  }
  stepper.collisions().remove(scratch.bodies);
}

void Engine::Parts::setAside(const world::Entities::Switched& switched) {
  std::vector<ManifoldPoints> touches;
  for (ManifoldPoints& points : listManifolds(stepper.collisions().dispatcher())) {
    const auto a = static_cast<world::Slot>(points.linkA), b = static_cast<world::Slot>(points.linkB);
    if (entities.links()[a].isSetAside || entities.links()[b].isSetAside) {
      keptTouches.push_back({bodies[a]->id(), bodies[b]->id(), std::move(points)});
    } else {
      touches.push_back(std::move(points));
    }
  }
  takeOut(switched.setAside);
  for (const world::Slot link : switched.returned) {
    bodies[link]->setGravity(gravity);
    take(*bodies[link]);
  }
  renumber();
  if (switched.returned.empty()) return;
  std::erase_if(keptTouches, [&](KeptTouch& touch) {
    const world::Slot a = entities.slot(touch.linkA), b = entities.slot(touch.linkB);
    if (a == world::kNoSlot || b == world::kNoSlot) return false;
    touch.points.linkA = static_cast<int>(a);
    touch.points.linkB = static_cast<int>(b);
    touches.push_back(std::move(touch.points));
    return true;
  });
  stepper.findTouches();
  restoreManifolds(touches, stepper.collisions().dispatcher());
}

void Engine::Parts::transferKeptTouches(StateArchive& archive) {
  std::size_t count = keptTouches.size();
  archive(count);
  archive.check(count <= archive.rest().size());
  if (archive.isGiving()) keptTouches.assign(count, KeptTouch());
  for (KeptTouch& touch : keptTouches) {
    // ids may be others in another run
    for (LinkId* id : {&touch.linkA, &touch.linkB}) {
      const auto found = std::ranges::lower_bound(bodies, *id, {}, [](const auto& body) { return body->id(); });
      auto slot = static_cast<std::uint64_t>(found - bodies.begin());
      archive(slot);
      if (archive.isGiving()) *id = slot < bodies.size() ? bodies[slot]->id() : LinkId();
    }
    archive(touch.points);
  }
}

void Engine::Parts::renumber() {
  renumberFrom(0, 0);
  frictionFrames.clear();
  frictionFrames.find(bodies, 0, entities);
}

void Engine::Parts::renumberFrom(world::Slot firstLink, world::Slot firstJoint) {
  // removed ones still have their old slots
  const auto kept = std::ranges::lower_bound(moving, firstLink, {}, &Body::link);
  const auto firstMember = static_cast<std::size_t>(kept - moving.begin());
  moving.erase(kept, moving.end());
  for (world::Slot link = firstLink; link < bodies.size(); ++link) {
    bodies[link]->setLink(link);
    if (bodies[link]->moves() && !entities.links()[link].isSetAside) moving.push_back(bodies[link].get());
  }
  stepper.setBodies(firstMember, std::span(moving).subspan(firstMember));

  for (world::Slot slot = firstJoint; slot < joints.size(); ++slot) joints[slot]->setSlot(slot);
  const std::size_t firstHolding = firstJoint == 0 ? 0 : holdingEnd[firstJoint - 1];
  holdingEnd.resize(firstJoint);
  std::vector<Joint*>& holding = scratch.joints;
  holding.clear();
  for (world::Slot slot = firstJoint; slot < joints.size(); ++slot) {
    if (joints[slot]->holdsSomething() && !entities.joints()[slot].isSetAside) holding.push_back(joints[slot].get());
    holdingEnd.push_back(firstHolding + holding.size());
  }
  stepper.setJoints(firstHolding, holding);
}

JointEnd Engine::Parts::end(world::Slot link, const Pose& X_LinkJoint) {
  if (link == world::kNoSlot) return {&anchor, toBullet(X_LinkJoint), false};
  Body& body = *bodies[link];
  return {&body.rigid(), toBullet(body.X_LinkBody().inverse() * X_LinkJoint), body.moves()};
}

Joint& Engine::Parts::jointWithAxis(world::Slot slot, std::size_t axis) {
  if (!hasAxis(slot, axis)) throw std::invalid_argument("the joint has no such axis");
  return *joints[slot];
}

void Engine::Parts::reportExplosion(world::Slot link) const {
  const world::LinkRecord& record = entities.links()[link];
  throw std::runtime_error("the motion of link '" + entities.models()[record.model].scopedName +
                           "::" + record.description->name + "' is no longer finite");
}

}  // namespace pongsim::physics
