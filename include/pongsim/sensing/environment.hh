#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/outcome.hh"
#include "pongsim/system.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// How the table of an environment is to be read.
struct EnvironmentSettings {
  /// What the columns for the place are.
  enum class Reference {
    /// x east, y north and z up from the origin of the world [m].
    kGlobal,
    /// Latitude, longitude and altitude [m] (WGS84).
    kSpherical,
    /// In the frame fixed to the earth: x to the zero meridian, z to the north pole [m].
    kEcef
  };
  std::string timeColumn = "t";
  std::array<std::string, 3> placeColumns{"x", "y", "z"};
  Reference reference = Reference::kGlobal;
  /// Whether latitude and longitude are in degrees, instead of radians.
  bool isInDegrees = false;
  /// Whether the first time of the table holds for ever.
  bool isStatic = false;
};

/// Quantities by time and place, such as humidity or the velocity of water, from a table. For each time, its points are
/// those of a grid, whose lines need not be equally far from each other. A point of the grid that is not in the table
/// counts as zero, as in Gazebo.
class PONGSIM_API Environment {
 public:
  /// @param csv Comma-separated values, with the names of the columns in the first line, and a number in each cell
  /// below. The order of the lines does not matter; of two with the same time and place the last counts.
  /// @return The environment, or why the table can't be read.
  static Outcome<Environment> fromCsv(std::string_view csv, const EnvironmentSettings& settings);

  /// @return The names of the columns with quantities.
  const std::vector<std::string>& quantities() const { return quantities_; }
  /// @return The index of a quantity; nothing if there is none of that name.
  std::optional<std::size_t> quantity(std::string_view name) const;
  /// @return The first and last time [s].
  std::pair<double, double> times() const;
  /// @return Points that the grids have and the table has not.
  std::size_t missingPoints() const { return missingPoints_; }

  /// @return The value, interpolated linearly in time and space; nothing outside of the table.
  /// @param place In the coordinates of the table, see `placeOf`.
  std::optional<double> at(std::size_t quantity, Time time, const Vector3& place) const;

  /// @param position In the world frame [m].
  /// @return The same place in the coordinates of the table; nothing if the table needs to know where on the earth the
  /// world is, and the world has no `<spherical_coordinates>`.
  std::optional<Vector3> placeOf(const Vector3& position, const World& world) const;

 private:
  /// The points of one time.
  struct Slice {
    double time = 0;
    /// The lines of the grid along each axis, ascending.
    std::array<std::vector<double>, 3> lines;
    /// The points, in lexicographic order.
    std::vector<Vector3> points;
    /// Of the first point; those of the others follow, each with one value for each quantity.
    std::size_t firstValue = 0;
  };
  struct Table;

  void addSlices(Table& table);
  double valueAt(const Slice& slice, std::size_t quantity, const Vector3& point) const;
  std::optional<double> at(const Slice& slice, std::size_t quantity, const Vector3& place) const;

  EnvironmentSettings settings_;
  std::vector<std::string> quantities_;
  std::vector<Slice> slices_;
  std::vector<double> values_;
  std::size_t missingPoints_ = 0;
};

/// Base class, beside `System`, of systems that share the environment of their world: one sets it, others read it, in
/// whatever order the file lists them.
class PONGSIM_API EnvironmentUser {
 public:
  EnvironmentUser();
  virtual ~EnvironmentUser();

 protected:
  /// Call it in `System::configure`.
  /// @param before As in the `SystemContext`.
  void shareEnvironment(std::span<System* const> before);
  void setEnvironment(Environment environment);
  /// @return The environment; null as long as no system has set it.
  const Environment* environment() const;
  /// @return How often it has been set.
  std::uint64_t environmentVersion() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace pongsim
