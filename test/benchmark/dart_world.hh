#pragma once

#include <memory>
#include <string>

#include "pongsim/types.hh"

namespace pongsim::benchmark {

/// A world in Fortress's engine, DART through ign-physics, with nothing around it.
class DartWorld {
 public:
  /// @throws std::runtime_error if the text is not a world, or the engine is not installed.
  explicit DartWorld(const std::string& sdf);
  ~DartWorld();
  DartWorld(DartWorld&&) noexcept;

  /// Drives all joints with this name from now on [rad/s].
  void setVelocity(const std::string& joint, double velocity);
  /// @param dt [s]
  void step(double dt);
  /// @param model Name of the model; empty: any.
  /// @return Position of the first link with this name, world frame [m].
  Vector3 position(const std::string& model, const std::string& link) const;

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim::benchmark
