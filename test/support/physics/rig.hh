#pragma once

#include <string>
#include <utility>
#include <vector>

#include "description/world.hh"
#include "physics/engine.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::test {

inline description::Link makeLink(std::string name, const Vector3& position, double mass, const Vector3& moments) {
  description::Link link;
  link.name = std::move(name);
  link.X_ModelLink.position = position;
  link.inertial.mass = mass;
  link.inertial.moments = moments.asDiagonal();
  return link;
}

inline void addCollision(description::Link& link, description::Geometry geometry, double mu = 1) {
  description::Collision collision;
  collision.name = "collision";
  collision.geometry = std::move(geometry);
  collision.surface.mu = mu;
  link.collisions.push_back(std::move(collision));
}

inline description::Model makeModel(std::string name, std::vector<description::Link> links) {
  description::Model model;
  model.name = std::move(name);
  model.canonicalLink = links.front().name;
  model.links = std::move(links);
  return model;
}

inline Pose at(double x, double y, double z) { return {{x, y, z}, Quaternion::Identity()}; }

/// A half space below a plane through the origin.
inline description::Model makeGround(double mu = 1, const Vector3& normal = Vector3::UnitZ()) {
  description::Link link;
  link.name = "link";
  addCollision(link, description::Plane{normal.normalized(), {1, 1}}, mu);
  description::Model model = makeModel("ground", {link});
  model.isStatic = true;
  return model;
}

/// Moments of inertia of a solid box of that mass [kg] and size [m].
inline Vector3 boxMoments(double mass, const Vector3& size) {
  const Vector3 squares = size.cwiseProduct(size);
  return mass / 12 * (Vector3::Constant(squares.sum()) - squares);
}

/// A joint whose frame lies there in the frames of parent and child; `axis` is left out where the type has none.
inline description::Joint makeJoint(std::string name, description::JointType type, std::string parent,
                                    std::string child, const Pose& X_ParentJoint, const Pose& X_ChildJoint,
                                    const Vector3& axis = Vector3::UnitZ()) {
  description::Joint joint;
  joint.name = std::move(name);
  joint.type = type;
  joint.parent = std::move(parent);
  joint.child = std::move(child);
  joint.X_ParentJoint = X_ParentJoint;
  joint.X_ChildJoint = X_ChildJoint;
  if (type != description::JointType::kBall && type != description::JointType::kFixed) {
    joint.axes.emplace_back().xyz = axis;
  }
  return joint;
}

/// A base and an arm beside it, both free to move unless the base is fixed to the world.
inline description::World twoLinks(description::JointType type, const Vector3& axis, bool baseIsFixed = true) {
  description::Model model = makeModel(
      "model", {makeLink("base", {0, 0, 0}, 5, {0.5, 0.5, 0.5}), makeLink("arm", {1, 0, 0}, 1, {0.1, 0.1, 0.1})});
  model.joints.push_back(makeJoint("joint", type, "base", "arm", at(1, 0, 0), Pose(), axis));
  if (baseIsFixed) {
    model.joints.push_back(makeJoint("root", description::JointType::kFixed, "world", "base", Pose(), Pose()));
  }
  description::World world;
  world.gravity.setZero();
  world.models = {model};
  return world;
}

/// A housing of 4 kg with two gears on it, their axes square to each other, and the gearbox between them as the last
/// joint: "b" turns -`ratio` times as far as "a". Joints: 0 and 1 the hinges of a and b, 2 the gearbox.
inline description::Model makeGearTrain(double ratio) {
  using description::JointType;
  description::Model model =
      makeModel("train", {makeLink("housing", {0, 0, 0}, 4, {0.3, 0.4, 0.5}),
                          makeLink("a", {1, 0, 0}, 1, {0.1, 0.2, 0.2}), makeLink("b", {0, 1, 0}, 1, {0.3, 0.05, 0.3})});
  model.joints.push_back(
      makeJoint("hinge_a", JointType::kRevolute, "housing", "a", at(1, 0, 0), Pose(), Vector3::UnitX()));
  model.joints.push_back(
      makeJoint("hinge_b", JointType::kRevolute, "housing", "b", at(0, 1, 0), Pose(), Vector3::UnitY()));
  description::Joint gearbox =
      makeJoint("gearbox", JointType::kGearbox, "a", "b", at(-1, 0, 0), at(0, -1, 0), Vector3::UnitX());
  gearbox.axes.emplace_back().xyz = Vector3::UnitY();
  gearbox.gearboxRatio = ratio;
  gearbox.gearboxReference = "housing";
  model.joints.push_back(gearbox);
  return model;
}

/// A world with what it needs to be stepped.
struct Rig {
  explicit Rig(description::World world, const physics::Settings& settings = physics::Settings())
      : description(std::move(world)), entities(description), state(entities), engine(entities, settings) {}

  void step(int count = 1) {
    for (int i = 0; i < count; ++i) engine.step(kStep, state);
  }
  const world::LinkState& link(std::string_view name) const { return state.links[entities.findLink(name)]; }
  const world::JointState& joint(world::Slot slot) const { return state.joints[slot]; }

  static constexpr Time kStep = std::chrono::milliseconds(1);
  const description::World description;
  world::Entities entities;
  world::State state;
  physics::Engine engine;
};

}  // namespace pongsim::test
