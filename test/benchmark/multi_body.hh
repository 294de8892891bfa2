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

/// A world in Bullet's reduced coordinates (`btMultiBody`, Featherstone's method), for models that are trees of links
/// with revolute and ball joints, and static ones of one link: what our own solver is compared with.
class MultiBodyWorld {
 public:
  /// @throws std::invalid_argument where it does not know how.
  MultiBodyWorld(const description::World& world, int iterations);
  ~MultiBodyWorld();

  /// Drives all joints of that name [rad/s].
  void setVelocity(std::string_view joint, double velocity);
  void step(double dt);
  /// @return Position of the base of the first model that moves.
  Vector3 basePosition() const;
  /// Of the first model that moves: angle [rad] and its derivative of the revolute joint that has that place in the
  /// file.
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
