#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "assets/picture_file.hh"
#include "assets/problem.hh"
#include "description/actor.hh"
#include "description/light.hh"
#include "description/material.hh"
#include "description/scene.hh"
#include "pongsim/diagnostic.hh"
#include "pongsim/types.hh"
#include "rendering/paint.hh"
#include "rendering/surface.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::rendering {

/// A surface in its place. A visual is one, or several where its mesh has parts.
struct Item {
  std::shared_ptr<const Surface> surface;
  Paint paint;
  /// Go over it; null: none.
  std::array<std::shared_ptr<const assets::Picture>, kMapCount> pictures;
  world::Slot link = world::kNoSlot;
  /// That holds the link.
  ModelId model;
  /// In place of a link; it moves by itself.
  const description::Actor* actor = nullptr;
  /// The visual's name.
  std::string visual;
  Pose X_LinkSurface;
  /// Along the axes of the surface, before it is turned.
  Vector3 scale = Vector3::Ones();
  /// Around the surface, in its own frame before scaling.
  Eigen::AlignedBox3d bounds;
  std::uint32_t visibility = 0xFFFFFFFF;
  bool castsShadows = true;
  /// It is ground, on which other things stand.
  bool isGround = false;
  Pose X_WorldLink;

  Pose X_WorldSurface() const { return X_WorldLink * X_LinkSurface; }
  /// In the world frame.
  Eigen::AlignedBox3d boundsInWorld() const;
};

/// A light in its place.
struct Lamp {
  const description::Light* light = nullptr;
  Pose X_WorldLight;
};

/// A part of a mesh file.
struct MeshPartLook {
  std::shared_ptr<const Surface> surface;
  std::optional<description::Material> material;
};
/// File, submesh, whether that is centred.
using MeshLookKey = std::tuple<std::filesystem::path, std::string, bool>;
using MeshLooks = std::map<MeshLookKey, std::vector<MeshPartLook>>;

/// The visuals and lights of a world in their places.
class Scene {
 public:
  /// What is told of a file that is of no use: "mesh", the file, what is wrong with it.
  using Warn = std::function<void(const std::string&, const std::filesystem::path&, const assets::Problem&)>;

  /// See `CameraScene::setColors`.
  void setColors(const std::optional<Vector3>& background, const std::optional<Vector3>& ambient);

  /// Takes in all visuals, in place of those that it has.
  /// @param diagnostics Warnings about files that can't be read; each is given once in the life of the scene.
  void build(const world::Entities& entities, const world::State& state, Diagnostics& diagnostics);

  /// Moves what has moved since, and takes in the lights.
  /// @param state Of the same entities.
  void update(const world::Entities& entities, const world::State& state);

  const std::vector<Item>& items() const { return items_; }
  const std::vector<Lamp>& lamps() const { return lamps_; }
  const description::Scene& surroundings() const { return surroundings_; }
  /// @return Goes up whenever items come or go.
  std::uint64_t version() const { return version_; }

  /// As `CameraScene::bounds`; `kNoSlot` stands for all models.
  Eigen::AlignedBox3d bounds(const world::Entities& entities, world::Slot model) const;
  /// As `CameraScene::actorBounds`.
  Eigen::AlignedBox3d actorBounds(const std::string& name) const;

 private:
  void addActor(const description::Actor& actor, Diagnostics& diagnostics);
  void addVisual(const description::Visual& visual, const Item& prototype, const std::string& owner,
                 Diagnostics& diagnostics);

  std::shared_ptr<const assets::Picture> pictureOf(const std::filesystem::path& file, const Warn& warn);

  std::vector<Item> items_;
  std::vector<Lamp> lamps_;
  description::Scene surroundings_;
  std::optional<Vector3> background_;
  std::optional<Vector3> ambient_;
  std::uint64_t version_ = 0;
  /// By what they show.
  std::map<std::string, std::shared_ptr<const Surface>> shapes_;
  MeshLooks meshes_;
  /// By their files; null where one can't be read.
  std::map<std::filesystem::path, std::shared_ptr<const assets::Picture>> pictures_;
  /// Warnings that were given.
  std::set<std::string> said_;
};

}  // namespace pongsim::rendering
