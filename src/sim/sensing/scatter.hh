#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "pongsim/random.hh"
#include "pongsim/sensing/beam_scene.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "sim/api/access.hh"

namespace pongsim::sim {

/// The particles of one emitter around a sensor, which scatter its light as in Fortress's renderer: of the beams that
/// meet a particle, a share comes back from behind its surface, by sqrt(3) |n|, where n is normally distributed with
/// the standard deviation s and a mean from 0 to s / 8. s is a quarter of the extent along x of a box around the
/// particles. A particle is an ellipse of its width and height that faces the sensor.
class Scatter {
 public:
  /// @param sensor A name, for the random numbers, which also depend on the run's seed and the time.
  Scatter(Access& access, std::string_view sensor);

  bool isAnything() const { return !clouds_.empty(); }

  /// See `CameraScene::scatterDepths`.
  void apply(const PictureView& view, std::span<float> depths);

  /// See `BeamScene::scatter`.
  void apply(const Pose& X_WorldSensor, std::span<const Vector3> directions, double minRange, double maxRange,
             std::span<Echo> echoes);

 private:
  struct Disc {
    Vector3 place;
    double halfWidth = 0;
    double halfHeight = 0;
  };
  struct Cloud {
    std::vector<Disc> discs;
    double ratio = 0;
    double deviation = 0;
  };
  /// @return The range that is measured instead of `behind`, with a particle at `range` in front of it.
  double scattered(const Cloud& cloud, double range, double behind);

  std::vector<Cloud> clouds_;
  Random draws_;
};

}  // namespace pongsim::sim
