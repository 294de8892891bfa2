#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "description/world.hh"

class btCollisionShape;
class btMultiBody;

namespace pongsim::benchmark {

/// A world in Bullet's reduced coordinates (`btMultiBody`, Featherstone's method), as a reference for our solver.
/// Supports models that are trees of links with revolute and ball joints, and static models of one link.
class MultiBodyWorld {
 public:
  /// @throws std::invalid_argument if the world has something else.
  MultiBodyWorld(const description::World& world, int iterations);
  ~MultiBodyWorld();

  /// Drives all joints with this name [rad/s].
  void setVelocity(std::string_view joint, double velocity);
  void step(double dt);
  /// @return Position of the base of the first model that is not static.
  Vector3 basePosition() const;
  /// Angle [rad] and its derivative, of a revolute joint of the first model that is not static.
  /// @param joint Its index in the order of the file.
  double angle(int joint) const;
  double rate(int joint) const;

 private:
  struct Parts;
  void addStatic(const description::Model& model);
  void addTree(const description::Model& model);
  void addCollider(btMultiBody& body, int index, const description::Link& link);
  btCollisionShape* addShape(const description::Link& link);

  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::benchmark
