#include "sensing/scene.hh"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "world/actor_motion.hh"

namespace pongsim::sensing {

namespace {

using description::TriangleMesh;
using world::Slot;

// Fortress's largest <laser_retro>
constexpr double kMostRetro = 2000;

Slot topLevelModel(const world::Entities& entities, Slot model) {
  while (entities.models()[model].parent != world::kNoSlot) model = entities.models()[model].parent;
  return model;
}

Echo echoOf(const Beam& beam, double minRange) {
  if (beam.hit == nullptr) return {kNowhere, 0};
  if (beam.range < minRange) return {-kNowhere, 0};
  return {beam.range, beam.hit->retro};
}

Pose poseOf(const Object& object, const world::State& state) {
  if (object.actor != nullptr) return world::actorPose(*object.actor, state);
  assert(object.link < state.links.size());
  return state.links[object.link].X_WorldLink;
}

/// @param count Number of objects of the scene so far.
void add(Object object, Group& group, std::size_t& count, const world::State& state) {
  object.order = count++;
  object.place(poseOf(object, state));
  group.objects().push_back(std::move(object));
}

}  // namespace

// One thread: more gain nothing for worlds of thousands of bodies, and only the simulation's thread is known to be
// free.
Scene::Scene() : device_(embree().newDevice("threads=1")), still_(device_.get()), moving_(device_.get()) {}

void Scene::build(const world::Entities& entities, const world::State& state, Diagnostics& diagnostics) {
  limbs_.clear();
  still_.objects().clear();
  moving_.objects().clear();
  std::size_t count = 0;
  for (Slot slot = 0; slot < entities.links().size(); ++slot) {
    const world::LinkRecord& link = entities.links()[slot];
    if (link.isSetAside) continue;
    for (const description::Visual& visual : link.description->visuals) {
      std::optional<Object> object = read(visual, "link '" + link.description->name + "'", diagnostics);
      if (!object) continue;
      object->link = slot;
      object->owner = entities.models()[topLevelModel(entities, link.model)].id;
      add(std::move(*object), link.isStatic ? still_ : moving_, count, state);
    }
  }
  for (const world::ActorRecord& actor : world::present(entities.actors())) {
    const std::vector<description::Visual> visuals = description::visualsOf(*actor.description);
    for (const description::Visual& visual : visuals) {
      std::optional<Object> object = read(visual, "actor '" + actor.description->name + "'", diagnostics);
      if (!object) continue;
      object->actor = actor.description;
      add(std::move(*object), moving_, count, state);
      if (&visual == &visuals.front() && !actor.description->skin.uri.empty()) {
        addLimbs(*actor.description, diagnostics);
      }
    }
  }
  pose(state);
  commit();
}

void Scene::addLimbs(const description::Actor& actor, Diagnostics& diagnostics) {
  const auto [known, isNew] = figures_.try_emplace(&actor);
  if (isNew) {
    known->second = assets::Figure::load(actor, [&](const std::filesystem::path& file, const assets::Problem& problem) {
      diagnostics.warning(actor.position,
                          "'" + file.string() + "' " + problem.text +
                              ": sensors will not see it move the limbs of actor '" + actor.name + "'",
                          problem.hint);
    });
  }
  const auto* mesh = std::get_if<const Mesh*>(&moving_.objects().back().body);
  if (known->second == nullptr || mesh == nullptr) return;
  Limbs limbs{&actor, known->second, moving_.objects().size() - 1, (*mesh)->triangles(), {}, {}, {}};
  for (const Vector3& vertex : limbs.atRest->vertices) {
    limbs.influences.push_back(known->second->influencesAt(vertex));
  }
  limbs_.push_back(std::move(limbs));
}

bool Scene::pose(const world::State& state) {
  bool hasMoved = false;
  for (Limbs& limbs : limbs_) {
    assets::Gait gait = world::actorGait(*limbs.actor, state);
    if (gait == limbs.gait) continue;
    const assets::Figure::Bones bones = limbs.figure->bonesIn(gait);
    auto mesh = std::make_shared<TriangleMesh>(*limbs.atRest);
    for (std::size_t i = 0; i < mesh->vertices.size(); ++i) {
      if (limbs.influences[i] == nullptr) continue;
      mesh->vertices[i] = assets::Figure::blend(*limbs.influences[i], bones) * mesh->vertices[i];
    }
    limbs.mesh = std::make_unique<const Mesh>(device_.get(), std::move(mesh));
    Object& object = moving_.objects()[limbs.object];
    object.body = limbs.mesh.get();
    object.bounds = limbs.mesh->bounds();
    limbs.gait = std::move(gait);
    hasMoved = true;
  }
  return hasMoved;
}

void Scene::update(const world::State& state) {
  for (Group* group : {&still_, &moving_}) {
    bool hasMoved = group == &moving_ && pose(state);
    for (Object& object : group->objects()) {
      const Pose X_WorldLink = poseOf(object, state);
      if (object.X_WorldLink == X_WorldLink) continue;
      object.place(X_WorldLink);
      hasMoved = true;
    }
    if (hasMoved) group->commit(reach_);
  }
}

void Scene::cast(const Beams& beams, std::span<const Vector3> directions, std::span<Echo> echoes,
                 std::span<Slot> links) {
  assert(echoes.size() == directions.size());
  assert(links.empty() || links.size() == directions.size());
  const double distance = beams.X_WorldSensor.position.norm();
  if (!(distance <= kMostDistance)) {
    std::ranges::fill(echoes, Echo{kNowhere, 0});
    std::ranges::fill(links, world::kNoSlot);
    return;
  }
  reachTo(distance);
  const Matrix3 R_WorldSensor = beams.X_WorldSensor.rotation.toRotationMatrix();
  BeamQuery query{};
  rtcInitIntersectContext(&query.context);
  query.owner = beams.owner;
  query.minRange = beams.minRange;
  query.visibilityMask = beams.visibilityMask;
  // a hit at exactly the maximum range counts
  const double farthest = std::nextafter(beams.maxRange, kNowhere);
  for (std::size_t first = 0; first < directions.size(); first += kBeamsAtATime) {
    query.count = std::min(kBeamsAtATime, directions.size() - first);
    for (std::size_t i = 0; i < query.count; ++i) {
      query.beams[i] = {{beams.X_WorldSensor.position, R_WorldSensor * directions[first + i]}, farthest, nullptr};
    }
    still_.cast(query);
    moving_.cast(query);
    for (std::size_t i = 0; i < query.count; ++i) echoes[first + i] = echoOf(query.beams[i], beams.minRange);
    if (links.empty()) continue;
    for (std::size_t i = 0; i < query.count; ++i) {
      links[first + i] = std::isfinite(echoes[first + i].range) ? query.beams[i].hit->link : world::kNoSlot;
    }
  }
}

void Scene::cast(std::span<const Ray> rays, double maxRange, std::uint32_t visibilityMask,
                 const std::function<void(std::size_t ray, const Beam& beam)>& use) {
  double farthestOrigin = 0;
  for (const Ray& ray : rays) {
    const double distance = ray.origin.norm();
    if (distance <= kMostDistance) farthestOrigin = std::max(farthestOrigin, distance);
  }
  reachTo(farthestOrigin);
  BeamQuery query{};
  rtcInitIntersectContext(&query.context);
  query.visibilityMask = visibilityMask;
  const double farthest = std::nextafter(maxRange, kNowhere);
  for (std::size_t first = 0; first < rays.size(); first += kBeamsAtATime) {
    query.count = std::min(kBeamsAtATime, rays.size() - first);
    for (std::size_t i = 0; i < query.count; ++i) {
      const auto& [origin, direction] = rays[first + i];
      // what is too far away, or no number, sees nothing
      const bool isWithin = origin.norm() <= kMostDistance;
      query.beams[i] = {{isWithin ? origin : Vector3::Zero(), direction}, isWithin ? farthest : 0, nullptr};
    }
    still_.cast(query);
    moving_.cast(query);
    for (std::size_t i = 0; i < query.count; ++i) use(first + i, query.beams[i]);
  }
}

/// Lets beams begin that far from the world's origin [m].
void Scene::reachTo(double distance) {
  if (distance <= reach_) return;
  // the next power of two, so that few scans make the boxes larger
  int exponent = 0;
  const bool isPower = std::frexp(distance, &exponent) == 0.5;
  reach_ = std::ldexp(1, isPower ? exponent - 1 : exponent);
  commit();
}

void Scene::commit() {
  still_.commit(reach_);
  moving_.commit(reach_);
}

std::optional<Object> Scene::read(const description::Visual& visual, const std::string& owner,
                                  Diagnostics& diagnostics) {
  const auto warn = [&](const std::string& kind, const std::filesystem::path& file, const assets::Problem& problem) {
    std::string text = kind + " '" + file.string() + "' " + problem.text + ": visual '" + visual.name + "' of " +
                       owner + " will not be seen by sensors";
    if (said_.insert(text).second) diagnostics.warning(visual.position, std::move(text), problem.hint);
  };
  RayGeometry geometry = reader_.read(visual.geometry, warn);
  Object object;
  if (auto* shape = std::get_if<Shape>(&geometry.body)) {
    object.body = *shape;
    object.bounds = boundsOf(*shape);
  } else if (const auto* triangles = std::get_if<std::shared_ptr<const TriangleMesh>>(&geometry.body)) {
    const Mesh& mesh = meshes_.try_emplace(*triangles, device_.get(), *triangles).first->second;
    object.body = &mesh;
    object.bounds = mesh.bounds();
  } else {
    return std::nullopt;
  }
  object.X_LinkObject = visual.X_LinkVisual * geometry.X_GeometryBody;
  object.scale = geometry.scale;
  object.visibility = visual.visibilityFlags;
  object.retro = std::clamp(visual.laserRetro, 0.0, kMostRetro);
  object.seesInside = visual.material && visual.material->isDoubleSided;
  return object;
}

}  // namespace pongsim::sensing
