#pragma once

#include <memory>
#include <string>

#include "pongsim/types.hh"

namespace pongsim::benchmark {

/// A world in DART by way of ign-physics, with nothing around it: the engine of Fortress's server.
class DartWorld {
 public:
  /// @throws std::runtime_error where the text is no world, or the engine is not there.
  explicit DartWorld(const std::string& sdf);
  ~DartWorld();
  DartWorld(DartWorld&&) noexcept;

  /// Drives all joints of that name from now on [rad/s].
  void setVelocity(const std::string& joint, double velocity);
  /// @param dt [s]
  void step(double dt);
  /// @return Position of the first link of that name in a model of that name, world frame [m]; any model if empty.
  Vector3 position(const std::string& model, const std::string& link) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim::benchmark
