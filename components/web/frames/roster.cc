#include "web/frames/roster.hh"

#include <algorithm>
#include <cassert>

#include "pongsim/scene.hh"

namespace pongsim::web {

namespace {

FramePose::Numbers numbersOf(const Pose& pose) {
  const auto narrow = [](double number) { return static_cast<float>(number); };
  const Vector3& p = pose.position;
  const Quaternion& q = pose.rotation;
  return {narrow(p.x()), narrow(p.y()), narrow(p.z()), narrow(q.x()), narrow(q.y()), narrow(q.z()), narrow(q.w())};
}

}  // namespace

Roster::Roster(const World& world) {
  for (const Model& model : world.models()) add(model);
  for (const ActorPlace& place : Scene(world).actors()) {
    if (const std::optional<Actor> actor = Actor::find(world, place.name)) actors_.push_back(*actor);
  }
}

void Roster::add(const Model& model) {
  const std::size_t first = links_.size();
  for (const Link& link : model.links()) links_.push_back(link);
  for (const Model& nested : model.models()) add(nested);
  ModelPlace place{.entity = static_cast<std::uint32_t>(model.id().value), .link = {}, .X_LinkModel = model.pose()};
  if (const std::optional<Link> canonical = model.canonicalLink()) {
    const auto found = std::ranges::find(links_.begin() + static_cast<std::ptrdiff_t>(first), links_.end(),
                                         canonical->id(), &Link::id);
    if (found != links_.end()) {
      place.link = static_cast<std::size_t>(found - links_.begin());
      place.X_LinkModel = canonical->pose().inverse() * model.pose();
    }
  }
  models_.push_back(place);
}

void Roster::poses(std::span<const Pose> X_WorldLinks, std::span<const Pose> X_WorldActors,
                   std::vector<FramePose>& poses) const {
  assert(X_WorldLinks.size() == links_.size() && X_WorldActors.size() == actors_.size());
  poses.clear();
  poses.reserve(links_.size() + models_.size() + actors_.size());
  for (const ModelPlace& model : models_) {
    const Pose X_WorldModel = model.link ? X_WorldLinks[*model.link] * model.X_LinkModel : model.X_LinkModel;
    poses.push_back({model.entity, numbersOf(X_WorldModel)});
  }
  for (std::size_t i = 0; i < links_.size(); ++i)
    poses.push_back({static_cast<std::uint32_t>(links_[i].id().value), numbersOf(X_WorldLinks[i])});
  for (std::size_t i = 0; i < actors_.size(); ++i)
    poses.push_back({static_cast<std::uint32_t>(actors_[i].id().value), numbersOf(X_WorldActors[i])});
}

}  // namespace pongsim::web
