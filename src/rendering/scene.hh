#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "assets/figures/figure.hh"
#include "assets/images/picture_file.hh"
#include "assets/problem.hh"
#include "description/actor.hh"
#include "description/light.hh"
#include "description/material.hh"
#include "description/scene.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/sensing/seen_visual.hh"
#include "pongsim/types.hh"
#include "pongsim/visual_colors.hh"
#include "rendering/paint.hh"
#include "rendering/placed_markers.hh"
#include "rendering/surface.hh"
#include "world/entities.hh"
#include "world/particles.hh"
#include "world/state.hh"

namespace pongsim::rendering {

/// Temperature of a surface: from its coldest to its hottest place.
struct Warmth {
  /// [K]
  double coldest = 0;
  double hottest = 0;
  /// How hot which place is: 0 to 1 in red. Null: everywhere as `coldest`.
  std::shared_ptr<const assets::Picture> signature;
};

/// A placed surface. A visual is one, or several if its mesh has parts.
struct Item {
  std::shared_ptr<const Surface> surface;
  Paint paint;
  /// Its textures; null: none.
  std::array<std::shared_ptr<const assets::Picture>, kMapCount> pictures;
  world::Slot link = world::kNoSlot;
  /// The model of the link.
  ModelId model;
  /// Set instead of a link; actors move by themselves.
  const description::Actor* actor = nullptr;
  /// The visual's name.
  std::string visual;
  /// Unset for one of an actor.
  VisualId id;
  /// Of the file, if the paint has others.
  Eigen::Vector3f fileDiffuse, fileAmbient, fileSpecular, fileEmissive;
  Pose X_LinkSurface;
  /// Along the axes of the surface, before rotation.
  Vector3 scale = Vector3::Ones();
  /// Index in `Scene::visuals`; the same for all parts of a mesh.
  std::size_t number = 0;
  /// Unset: like the air.
  std::optional<Warmth> warmth;
  /// Bounding box of the surface, in its own frame before scaling.
  Eigen::AlignedBox3d bounds;
  std::uint32_t visibility = 0xFFFFFFFF;
  bool castsShadows = true;
  /// Whether it is ground on which other things stand.
  bool isGround = false;
  Pose X_WorldLink;

  Pose X_WorldSurface() const { return X_WorldLink * X_LinkSurface; }
  /// In the world frame.
  Eigen::AlignedBox3d boundsInWorld() const;
};

/// A placed light.
struct Lamp {
  /// A copy, so that a scene can be drawn while another thread changes the world.
  description::Light light;
  Pose X_WorldLight;
};

/// A particle: a rectangle parallel to the image.
struct Billboard {
  /// Of its centre, in the world frame.
  Vector3 place;
  /// [m]
  double halfWidth = 0;
  double halfHeight = 0;
  Eigen::Vector4f color;
  /// Null: none.
  std::shared_ptr<const assets::Picture> picture;
};

/// A part of a mesh file.
struct MeshPartLook {
  std::shared_ptr<const Surface> surface;
  std::optional<description::Material> material;
};
/// File, submesh, whether that is centred.
using MeshLookKey = std::tuple<std::filesystem::path, std::string, bool>;
using MeshLooks = std::map<MeshLookKey, std::vector<MeshPartLook>>;

/// The visuals and lights of a world, placed.
class Scene {
 public:
  /// Called for each unusable file: "mesh", the file, what is wrong with it.
  using Warn = std::function<void(const std::string&, const std::filesystem::path&, const assets::Problem&)>;

  /// See `CameraScene::setColors`.
  void setColors(const std::optional<Vector3>& background, const std::optional<Vector3>& ambient);

  /// Adds a light of the world to those of the entities, for good.
  void addLight(const description::Light& light) { addedLights_.push_back(light); }

  /// Collects all visuals, replacing the current ones.
  /// @param diagnostics Warnings about files that can't be read, each given once in the scene's lifetime.
  void build(const world::Entities& entities, const world::State& state, Diagnostics& diagnostics);

  /// Gives visuals other colours, and all others those of the file again.
  void paint(const std::map<VisualId, VisualColors>& colors);

  /// Replaces all particles.
  /// @param time Now.
  void place(const world::Particles& particles, const world::Entities& entities, Time time);

  /// Updates the poses of what has moved, and the lights.
  /// @param state Of the same entities.
  void update(const world::Entities& entities, const world::State& state);

  /// Shows these markers instead of others, at the current poses of their parents.
  void show(const MarkerList& markers, const world::Entities& entities, const world::State& state) {
    if (markers_.update(markers, entities, state)) ++version_;
  }

  const std::vector<Item>& items() const { return items_; }
  std::span<const PlacedMarker> markers() const { return markers_.all(); }
  const std::vector<Lamp>& lamps() const { return lamps_; }
  const std::vector<Billboard>& billboards() const { return billboards_; }
  /// See `CameraScene::visuals`.
  const std::vector<SeenVisual>& visuals() const { return visuals_; }
  const description::Scene& surroundings() const { return surroundings_; }
  /// @return Simulated time of the last `update`.
  Time time() const { return time_; }
  /// @return A number that increases whenever items are added or removed, or have another surface,
  /// and likewise markers.
  std::uint64_t version() const { return version_; }

  /// See `CameraScene::bounds`; `kNoSlot` means all models.
  Eigen::AlignedBox3d bounds(const world::Entities& entities, world::Slot model) const;
  /// See `CameraScene::actorBounds`.
  Eigen::AlignedBox3d actorBounds(const std::string& name) const;

 private:
  void addActor(const description::Actor& actor, Diagnostics& diagnostics);
  /// @param first Of the items of its skin.
  void addLimbs(const description::Actor& actor, std::size_t first, Diagnostics& diagnostics);
  void addVisual(const description::Visual& visual, const Item& prototype, const std::string& owner,
                 Diagnostics& diagnostics);

  /// Bends the limbs of actors.
  void pose(const world::State& state);

  std::shared_ptr<const assets::Picture> pictureOf(const std::filesystem::path& file, const Warn& warn);
  /// @return The images of an emitter: that of its particles, and that of their colours.
  std::array<std::shared_ptr<const assets::Picture>, 2> picturesOf(const description::ParticleEmitter& emitter,
                                                                   const Warn& warn);

  /// @return What `thermal` says of a visual.
  std::optional<Warmth> warmthOf(const std::optional<description::Heat>& heat, const Warn& warn);

  std::vector<Item> items_;
  std::vector<SeenVisual> visuals_;
  /// Of the world's atmosphere [K].
  double airTemperature_ = 0;
  std::vector<Lamp> lamps_;
  std::vector<description::Light> addedLights_;
  std::vector<Billboard> billboards_;
  PlacedMarkers markers_;
  description::Scene surroundings_;
  std::optional<Vector3> background_;
  std::optional<Vector3> ambient_;
  Time time_{0};
  std::uint64_t version_ = 0;
  bool isPainted_ = false;
  /// Keyed by what they show.
  std::map<std::string, std::shared_ptr<const Surface>> shapes_;
  MeshLooks meshes_;
  /// Keyed by file; null if one can't be read.
  std::map<std::filesystem::path, std::shared_ptr<const assets::Picture>> pictures_;
  /// Warnings already given.
  std::set<std::string> said_;
  /// An actor whose limbs move.
  struct Limbs {
    const description::Actor* actor;
    std::shared_ptr<const assets::Figure> figure;
    /// Of its skin, in `items_`.
    std::size_t item;
    std::shared_ptr<const Surface> atRest;
    /// Of each vertex; null: it stays.
    std::vector<const std::vector<assets::Skeleton::Influence>*> influences;
    std::optional<assets::Gait> gait;
  };
  std::vector<Limbs> limbs_;
  /// By actor; null where limbs don't move.
  std::map<const description::Actor*, std::shared_ptr<const assets::Figure>> figures_;
};

}  // namespace pongsim::rendering
