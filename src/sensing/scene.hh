#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "pongsim/diagnostic.hh"
#include "pongsim/sensing/beam_scene.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::sensing {

/// Parameters of a scan.
struct Beams {
  /// Origin of the beams.
  Pose X_WorldSensor;
  /// Top-level model of the sensor.
  ModelId owner;
  /// [m]
  double minRange = 0;
  double maxRange = 0;
  /// A visual is visible if it shares a bit with its visibility flags.
  std::uint32_t visibilityMask = 0xFFFFFFFF;
};

/// The visuals of a world for lidars, static ones separate from moving ones. See `BeamScene`.
class Scene {
 public:
  Scene();
  ~Scene();

  /// Replaces all visuals.
  /// @param diagnostics Warnings about files that can't be read, each once in the life of the scene.
  void build(const world::Entities& entities, const world::State& state, Diagnostics& diagnostics);

  /// Moves what has moved since.
  /// @param state Of the same entities.
  void update(const world::State& state);

  /// Like `BeamScene::cast`.
  void cast(const Beams& beams, std::span<const Vector3> directions, std::span<Echo> echoes);

 private:
  class Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim::sensing
