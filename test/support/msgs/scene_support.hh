#pragma once

#include "description/world.hh"

namespace pongsim::test {

/// @return A world "w" at whose start are: a static model "ground" with a link "l"; a model "cart" at x = 1, whose link
/// "base" at z = 2 has a visual, a collision, a light and an inertial measurement unit, and in which a model "arm" is
/// nested, whose link "tip" hangs on "base" by a joint "hinge" about y; and the light "sun".
inline description::World cartWorld() {
  description::Model ground;
  ground.name = "ground";
  ground.isStatic = true;
  ground.canonicalLink = "l";
  ground.links.resize(1);
  ground.links[0].name = "l";

  description::Model arm;
  arm.name = "arm";
  arm.canonicalLink = "tip";
  arm.X_ParentModel.position.z() = 3;
  arm.links.resize(1);
  arm.links[0].name = "tip";
  arm.links[0].inertial.mass = 0.5;

  description::Model cart;
  cart.name = "cart";
  cart.canonicalLink = "base";
  cart.X_ParentModel.position.x() = 1;
  description::Link& base = cart.links.emplace_back();
  base.name = "base";
  base.X_ModelLink.position.z() = 2;
  base.visuals.resize(1);
  base.visuals[0].name = "look";
  base.visuals[0].geometry = description::Sphere{0.5};
  base.visuals[0].material.emplace().diffuse.red = 0.5F;
  base.collisions.resize(1);
  base.collisions[0].name = "hull";
  base.lights.resize(1);
  base.lights[0].name = "lamp";
  description::Sensor& imu = base.sensors.emplace_back();
  imu.name = "gyro";
  imu.type = "imu";
  imu.settings = ImuSettings{};
  cart.models = {arm};
  description::Joint& hinge = cart.joints.emplace_back();
  hinge.name = "hinge";
  hinge.type = description::JointType::kRevolute;
  hinge.parent = "base";
  hinge.child = "arm::tip";
  hinge.axes.resize(1);
  hinge.axes[0].xyz = Vector3::UnitY();

  description::World world;
  world.name = "w";
  world.models = {ground, cart};
  world.lights.resize(1);
  world.lights[0].name = "sun";
  return world;
}

}  // namespace pongsim::test
