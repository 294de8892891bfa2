#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "assets/problem.hh"
#include "pongsim/types.hh"

namespace pongsim::assets {

/// Where a bone is in the frame of its parent, at times. In the units of its file.
class Track {
 public:
  /// Replaces a frame at the same time. Times may come in any order.
  void add(double time, const Eigen::Affine3d& X_ParentBone);

  /// @return The rotation in a transform that may scale.
  static Quaternion rotationIn(const Eigen::Affine3d& transform);

  /// @return Time of the last frame [s].
  double length() const { return frames_.empty() ? 0 : frames_.rbegin()->first; }
  /// @return Its place, between frames on a straight line and by an even turn. Before the first frame that one, as in
  /// Fortress.
  Pose at(double time) const;
  /// @return How far along x the last frame is.
  double lastX() const { return frames_.empty() ? 0 : frames_.rbegin()->second.position.x(); }
  double firstX() const { return frames_.empty() ? 0 : frames_.begin()->second.position.x(); }
  void scale(double factor);
  /// @return The first time at which it has come that far along x; the last one if it never does.
  double timeAtX(double x) const;

 private:
  std::map<double, Pose> frames_;
};

/// How bones move, by their names.
struct Motion {
  std::map<std::string, Track> tracks;

  /// [s]
  double length() const;
  /// Multiplies all places of bones.
  void scale(double factor);
};

/// The skeleton of a mesh file.
struct Skeleton {
  struct Bone {
    std::string name;
    /// Index; the bone itself for one without a parent. Parents come first.
    std::size_t parent = 0;
    /// At rest.
    Eigen::Affine3d X_ParentBone = Eigen::Affine3d::Identity();
  };
  /// A bone that moves vertices.
  struct Joint {
    std::size_t bone = 0;
    /// From the vertices' place in the file [m] to the frame of the bone.
    Eigen::Affine3d M_BoneFile = Eigen::Affine3d::Identity();
  };
  /// Share of a joint in the place of a vertex.
  struct Influence {
    std::size_t joint = 0;
    double weight = 0;
  };
  struct Vertex {
    /// Its place in the file at rest [m].
    Vector3 position;
    std::vector<Influence> influences;
  };

  /// Of which the first is the root: what is above it has no effect, as in Fortress.
  std::vector<Bone> bones;
  std::vector<Joint> joints;
  std::vector<Vertex> vertices;
  /// Metres per unit of the bones' places.
  double unit = 1;
  /// Of the same file; without tracks if it has none.
  Motion motion;
};

/// Reads the skeleton of the first `<skin>` of a Collada file, and its vertices' weights, as far as `readMeshFile`
/// would accept the file. Of each skin the vertices are read.
/// @return Nothing if the file has none.
std::variant<std::optional<Skeleton>, Problem> readSkeleton(const std::filesystem::path& file);

}  // namespace pongsim::assets
