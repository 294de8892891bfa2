#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/sensor.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// What comes back of a beam.
struct Echo {
  /// To the first surface that the beam meets [m]; infinite where it meets none, minus infinity where that is nearer
  /// than the sensor can tell.
  double range = 0;
  /// `<laser_retro>` of what it meets; zero where `range` is not finite.
  double intensity = 0;
};

/// The visuals of a world, as the beams of sensors meet them.
///
/// As in Fortress a beam sees surfaces from outside only, unless their material says `<double_sided>`: a sensor within
/// a body looks out of it. Planes are as large as their `<size>`. Visuals of the model that the sensor is part of are
/// not seen nearer than the least range, so that a sensor sees out of its housing. Where the same surface is met does
/// not depend on where in the world it is: ranges are reckoned in double precision.
class PONGSIM_API BeamScene {
 public:
  /// Of a world in which it sees nothing yet.
  /// @throws std::runtime_error where Embree is not installed, saying which package to install.
  explicit BeamScene(const World& world);
  ~BeamScene();

  /// Takes in the visuals, and reads the files of their meshes. To be called at first, and where models have come or
  /// gone (`System::worldChanged`).
  /// @param diagnostics Warnings about files that can't be read: what they show is not seen.
  void rebuild(Diagnostics& diagnostics);

  /// Lets everything be where it is now. To be called before `cast`, once a step.
  void update();

  /// Casts beams from a sensor as it stood at the last `update`.
  /// @param directions In the sensor frame, of length one.
  /// @param minRange, maxRange [m]
  /// @param visibilityMask A visual is seen where one of these bits is in its `<visibility_flags>`.
  /// @param echoes As many as there are directions.
  void cast(const Sensor& sensor, std::span<const Vector3> directions, double minRange, double maxRange,
            std::uint32_t visibilityMask, std::span<Echo> echoes);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim
