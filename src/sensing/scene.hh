#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "assets/figures/figure.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/sensing/beam_scene.hh"
#include "pongsim/sensing/ray_scene.hh"
#include "pongsim/types.hh"
#include "sensing/embree.hh"
#include "sensing/group.hh"
#include "sensing/mesh.hh"
#include "sensing/object.hh"
#include "sensing/ray_geometry.hh"
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
  /// @throws std::runtime_error if Embree is not installed.
  Scene();

  /// Replaces all visuals.
  /// @param diagnostics Warnings about files that can't be read, each once in the life of the scene.
  void build(const world::Entities& entities, const world::State& state, Diagnostics& diagnostics);

  /// Moves what has moved since.
  /// @param state Of the same entities.
  void update(const world::State& state);

  /// Like `BeamScene::cast`.
  /// @param links Empty, or one for each direction: the link that was hit; `world::kNoSlot` for an actor, and without a
  /// range.
  void cast(const Beams& beams, std::span<const Vector3> directions, std::span<Echo> echoes,
            std::span<world::Slot> links = {});

  /// Calls `use` with the index of each ray and its beam, which knows what it has hit.
  void cast(std::span<const Ray> rays, double maxRange, std::uint32_t visibilityMask,
            const std::function<void(std::size_t ray, const Beam& beam)>& use);

 private:
  void commit();
  void reachTo(double distance);
  /// @param owner "link 'l'"
  /// @return The visual without its place; nothing if it is not visible.
  std::optional<Object> read(const description::Visual& visual, const std::string& owner, Diagnostics& diagnostics);

  /// Makes the last object of `moving_` one whose limbs move, if they do.
  void addLimbs(const description::Actor& actor, Diagnostics& diagnostics);
  /// Bends the limbs of actors.
  /// @return Whether any has moved.
  bool pose(const world::State& state);

  /// An actor whose limbs move.
  struct Limbs {
    const description::Actor* actor;
    std::shared_ptr<const assets::Figure> figure;
    /// Of its skin, in `moving_`.
    std::size_t object;
    std::shared_ptr<const description::TriangleMesh> atRest;
    /// Of each vertex; null: it stays.
    std::vector<const std::vector<assets::Skeleton::Influence>*> influences;
    std::optional<assets::Gait> gait;
    std::unique_ptr<const Mesh> mesh;
  };

  DevicePointer device_;
  RayGeometryReader reader_;
  /// One for all visuals with the same triangles.
  std::map<std::shared_ptr<const description::TriangleMesh>, Mesh> meshes_;
  /// By actor; null where limbs don't move.
  std::map<const description::Actor*, std::shared_ptr<const assets::Figure>> figures_;
  std::vector<Limbs> limbs_;
  /// Warnings that were given.
  std::set<std::string> said_;
  /// Largest distance of beam origins from the world's origin [m].
  double reach_ = 1;
  Group still_;
  Group moving_;
};

}  // namespace pongsim::sensing
