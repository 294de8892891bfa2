#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "pongsim/beam_scene.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::sensing {

/// How beams are cast.
struct Beams {
  /// Where they start.
  Pose X_WorldSensor;
  /// Model at the top level that the sensor is part of.
  ModelId owner;
  /// [m]
  double minRange = 0;
  double maxRange = 0;
  /// A visual is seen where one of these bits is in its visibility flags.
  std::uint32_t visibilityMask = 0xFFFFFFFF;
};

/// The visuals of a world, as beams meet them: what stands still apart from what moves. See `BeamScene`.
class Scene {
 public:
  Scene();
  ~Scene();

  /// Takes in all visuals, in place of those that it has.
  /// @param diagnostics Warnings about files that can't be read; each is given once in the life of the scene.
  void build(const world::Entities& entities, const world::State& state, Diagnostics& diagnostics);

  /// Moves what has moved since.
  /// @param state Of the same entities.
  void update(const world::State& state);

  /// As `BeamScene::cast`.
  void cast(const Beams& beams, std::span<const Vector3> directions, std::span<Echo> echoes);

 private:
  class Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim::sensing
