#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// Result of a lidar beam.
struct Echo {
  /// Distance to the first surface hit [m]; infinite without a hit, minus infinity if the hit is closer than the
  /// minimum range.
  double range = 0;
  /// `<laser_retro>` of the visual hit; zero if `range` is not finite.
  double intensity = 0;
};

/// The visuals of a world, for lidars.
///
/// As in Fortress, beams hit surfaces from outside only, unless their material is `<double_sided>`: a sensor inside a
/// body sees out of it. Planes are as large as their `<size>`. Visuals of the sensor's own model are ignored below the
/// minimum range, so that a sensor sees out of its housing. Ranges are computed in double precision, so they do not
/// depend on the place in the world.
class PONGSIM_API BeamScene {
 public:
  /// A scene without visuals; call `rebuild`.
  /// @throws std::runtime_error if Embree is not installed; the message names the package.
  explicit BeamScene(const World& world);
  ~BeamScene();

  /// Adds the visuals and reads their mesh files. Call it first, and after models were added or removed
  /// (`System::worldChanged`).
  /// @param diagnostics Warnings about files that can't be read; their visuals are left out.
  void rebuild(Diagnostics& diagnostics);

  /// Moves everything to its current pose. Call it before `cast`, once per step.
  void update();

  /// Casts beams from a sensor at its pose of the last `update`.
  /// @param directions Unit vectors in the sensor frame.
  /// @param minRange, maxRange [m]
  /// @param visibilityMask A visual is visible if it shares a bit with its `<visibility_flags>`.
  /// @param echoes One for each direction.
  void cast(const Sensor& sensor, std::span<const Vector3> directions, double minRange, double maxRange,
            std::uint32_t visibilityMask, std::span<Echo> echoes);

  /// The same, and says what was hit.
  /// @param targets One for each direction: the link of the visual; nothing for an actor, and without a range.
  void cast(const Sensor& sensor, std::span<const Vector3> directions, double minRange, double maxRange,
            std::uint32_t visibilityMask, std::span<Echo> echoes, std::span<std::optional<LinkId>> targets);

  /// Lets particles of the world's emitters scatter the beams, as in Fortress (docs/sensors.md). Which beams depends on
  /// the sensor's name, the run's seed and the time.
  /// @param directions, minRange, maxRange As for `cast`.
  /// @param echoes From `cast`.
  void scatter(const Sensor& sensor, std::span<const Vector3> directions, double minRange, double maxRange,
               std::span<Echo> echoes);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim
