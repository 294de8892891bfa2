#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "assets/figures/gait.hh"
#include "assets/figures/skeleton.hh"
#include "assets/problem.hh"
#include "description/actor.hh"
#include "pongsim/types.hh"

namespace pongsim::assets {

/// An actor's skin with its skeleton and animations.
class Figure {
 public:
  /// Called with a file and what is wrong with it.
  using Warn = std::function<void(const std::filesystem::path& file, const Problem& problem)>;

  /// Reads the files of an actor.
  /// @return Null if its limbs can't move: its skin has no skeleton, or nothing moves it.
  static std::unique_ptr<Figure> load(const description::Actor& actor, const Warn& warn);

  /// From vertices at rest to vertices in a gait, one for each joint.
  using Bones = std::vector<Eigen::Affine3d>;
  Bones bonesIn(const Gait& gait) const;

  /// Which joints move a vertex; found by its place. Null: none, it stays where it is in the file.
  /// @param position Of a vertex at rest, as in the mesh file [m].
  const std::vector<Skeleton::Influence>* influencesAt(const Vector3& position) const;

  /// @return The transform of a vertex with these influences.
  static Eigen::Affine3d blend(const std::vector<Skeleton::Influence>& influences, const Bones& bones);

 private:
  struct Animation {
    Motion motion;
    bool followsX = false;
  };
  using Cell = std::array<std::int64_t, 3>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };

  explicit Figure(Skeleton skeleton);
  void addAnimation(const description::Animation& animation, const Warn& warn);
  /// @return The motion in a file, in the skin's units.
  std::variant<Motion, Problem> colladaMotion(const std::filesystem::path& file) const;
  std::variant<Motion, Problem> bvhMotionOf(const description::ActorFile& source) const;
  Cell cellOf(const Vector3& position) const;
  /// @return The time in the animation.
  double timeIn(const Animation& animation, const Gait& gait) const;

  Skeleton skeleton_;
  Animation own_;
  std::map<std::string, Animation> animations_;
  /// Edge of a cell [m].
  double cell_ = 1;
  std::unordered_multimap<Cell, std::size_t, CellHash> vertices_;
};

}  // namespace pongsim::assets
