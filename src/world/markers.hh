#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/outcome.hh"
#include "pongsim/types.hh"

namespace pongsim::world {

/// A shape that programs add to what is seen, such as a planned path. Nothing collides with it.
struct Marker {
  /// With the numbers of `ignition.msgs.Marker.Type`.
  enum class Type : std::uint8_t {
    kNone = 0,
    kBox = 1,
    kCylinder = 2,
    kLineStrip = 3,
    kLineList = 4,
    kPoints = 5,
    kSphere = 6,
    kText = 7,
    kTriangleFan = 8,
    kTriangleList = 9,
    kTriangleStrip = 10,
    kCone = 11,
    kArrow = 12,
    kAxis = 13,
    kCapsule = 14,
    kEllipsoid = 15
  };
  Type type = Type::kNone;
  /// In the frame of its parent.
  Pose X_ParentMarker;
  /// Along its own axes.
  Vector3 scale = Vector3::Ones();
  /// Red, green, blue, opacity: 0 to 1.
  Eigen::Vector4f color = Eigen::Vector4f::Ones();
  /// Of lines, points and triangles, in its frame.
  std::vector<Vector3> points;
  std::string text;
  /// "model", "model::link" or "model::link::visual"; empty: the world.
  std::string parent;
  /// Whether those see it, too, whose markers it is not among (`MarkerViewers`).
  bool isForAll = false;
  std::int32_t layer = 0;
  /// When it goes; unset: never.
  std::optional<Time> end;
};

/// What a message asks for.
struct MarkerChange {
  enum class Action { kAddOrModify, kDelete, kDeleteAll };
  Action action = Action::kAddOrModify;
  /// Name space and number of a marker.
  std::string space;
  std::uint64_t id = 0;
  Marker::Type type = Marker::Type::kNone;
  std::int32_t layer = 0;
  bool isForAll = false;
  /// Zero: for ever.
  Time lifetime{0};
  /// What is unset or empty stays as it is.
  std::optional<Pose> pose;
  std::optional<Vector3> scale;
  std::optional<Eigen::Vector4f> color;
  std::vector<Vector3> points;
  std::string text;
  std::string parent;
};

/// The markers of a world for some viewers. They are no part of its state: nothing depends on them.
class Markers {
 public:
  /// Limits, because anybody can add markers.
  static constexpr std::size_t kMost = 10'000;
  static constexpr std::size_t kMostPoints = 1'000'000;
  /// A letter is drawn with about as many points.
  static constexpr std::size_t kPointsOfLetter = 60;
  static constexpr std::size_t kLongestText = 1000;

  /// Name space and number.
  using Key = std::pair<std::string, std::uint64_t>;
  using Map = std::map<Key, std::shared_ptr<const Marker>>;

  /// A new marker without a number gets one that is free.
  /// @return The marker that it was about; for `kDeleteAll` only its name space counts.
  Outcome<Key> apply(const MarkerChange& change, Time now);

  /// Drops markers whose time is over; if time goes back, as at a reset, all that have one (as in Fortress).
  /// @return Those that are gone.
  std::vector<Key> advance(Time now);

  const Map& all() const { return all_; }
  /// @return A number that changes with the markers.
  std::uint64_t version() const { return version_; }

 private:
  Outcome<Key> add(const MarkerChange& change, Time now);
  Outcome<Key> remove(const MarkerChange& change);
  void erase(Map::const_iterator marker);

  Map all_;
  std::size_t points_ = 0;
  std::uint64_t version_ = 0;
  /// Numbers that nobody would choose.
  std::uint64_t nextId_ = std::uint64_t{1} << 31U;
  Time last_{0};
  /// No marker ends earlier.
  Time firstEnd_ = Time::max();
};

}  // namespace pongsim::world
