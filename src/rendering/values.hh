#pragma once

#include "description/environment.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "rendering/gl.hh"
#include "rendering/program.hh"
#include "rendering/scene.hh"
#include "rendering/store.hh"

namespace pongsim::rendering {

// What is drawn for pictures of one number per pixel, without lights: each class has a program, and sets its uniforms
// for each surface.

/// Draws depths along the camera's axis [m].
class DepthPass {
 public:
  explicit DepthPass(const Gl& gl);
  /// @param ahead The camera's axis in the world frame.
  void setAhead(const Vector3& ahead) { ahead_ = ahead; }
  void use() const;
  void set(const Item&, Store&) const {}

 private:
  const Gl& gl_;
  Program program_;
  Vector3 ahead_ = Vector3::UnitX();
};

/// Draws 1 + `Item::number`.
class NumberPass {
 public:
  explicit NumberPass(const Gl& gl);
  /// The value where nothing is.
  static constexpr float kNothing = 0;
  void use() const { program_.use(); }
  void set(const Item& item, Store& store) const;

 private:
  const Gl& gl_;
  Program program_;
};

/// Temperatures of the air [K]: of black surfaces, and of white ones.
struct AirTemperatures {
  double coldest = 0;
  double hottest = 0;
};

/// As in Fortress: around the temperature at height zero, with the difference between the lowest and the highest place
/// that the camera sees at its far clip distance. Fortress computes that with the quotient of width and height as an
/// integer, and so does this.
AirTemperatures airTemperatures(const description::Atmosphere& atmosphere, const PictureView& view);

/// Draws temperatures [K].
class TemperaturePass {
 public:
  explicit TemperaturePass(const Gl& gl);
  void setAir(const AirTemperatures& air) { air_ = air; }
  void use() const { program_.use(); }
  void set(const Item& item, Store& store) const;

 private:
  const Gl& gl_;
  Program program_;
  AirTemperatures air_;
};

}  // namespace pongsim::rendering
