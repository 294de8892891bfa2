#include "pongsim/actor.hh"

#include <algorithm>

#include "sim/api/access.hh"
#include "sim/edits/editor.hh"
#include "world/actor_motion.hh"

namespace pongsim {

namespace {

const world::ActorRecord* findActor(const sim::Access& access, ActorId id) {
  const auto found = std::ranges::find(access.entities.actors(), id, &world::ActorRecord::id);
  return found == access.entities.actors().end() || found->isSetAside ? nullptr : &*found;
}

const description::Actor& actorAt(const sim::Access& access, ActorId id) {
  const world::ActorRecord* const found = findActor(access, id);
  if (found == nullptr) {
    throw Gone("the actor with the id " + std::to_string(id.value) + " no longer exists");
  }
  return *found->description;
}

}  // namespace

std::optional<Actor> Actor::find(const World& world, std::string_view name) {
  for (const world::ActorRecord& actor : world::present(world.access_->entities.actors())) {
    if (actor.description->name == name) return Actor(*world.access_, actor.id);
  }
  return std::nullopt;
}

bool Actor::exists() const { return findActor(*access_, id_) != nullptr; }

std::string_view Actor::name() const { return actorAt(*access_, id_).name; }

std::vector<std::string> Actor::animations() const {
  std::vector<std::string> names;
  for (const description::Animation& animation : actorAt(*access_, id_).animations) names.push_back(animation.name);
  return names;
}

Pose Actor::startPose() const { return actorAt(*access_, id_).X_WorldActor; }

Pose Actor::pose() const { return world::actorPose(actorAt(*access_, id_), access_->state); }

void Actor::move(const Pose& X_WorldActor, std::string_view animation, Time animationTime) {
  const description::Actor& actor = actorAt(*access_, id_);
  if (const char* fault = sim::poseFault(X_WorldActor)) {
    access_->refuse("actor '" + actor.name + "' was given a pose that " + fault);
    return;
  }
  std::vector<world::ActorState>& actors = access_->state.actors;
  auto found = std::ranges::find(actors, &actor, &world::ActorState::description);
  if (found == actors.end()) found = actors.insert(found, {&actor, {}, {}, {}});
  found->X_WorldActor = X_WorldActor;
  if (found->animation != animation) found->animation = animation;
  found->animationTime = animationTime;
}

}  // namespace pongsim
