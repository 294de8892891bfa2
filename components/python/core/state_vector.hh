#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/life.hh"
#include "core/owner.hh"
#include "pongsim/handles.hh"
#include "pongsim/simulation.hh"

namespace pongsim::python {

/// Velocity of a model's frame: that of its origin [m/s] and the angular velocity [rad/s], in the world frame.
struct Twist {
  Vector3 linear = Vector3::Zero();
  Vector3 angular = Vector3::Zero();
};

/// Everything that moves, as a vector of positions and one of velocities: for each top-level model first what is free
/// (7 positions: x, y, z and a quaternion x, y, z, w; 6 velocities: linear and angular), then the axes of its joints.
/// All in the world frame, and joints in [rad or m].
class StateVector {
 public:
  explicit StateVector(Simulation& simulation);
  /// @return Whether the world still has the same models and joints.
  bool fits(Simulation& simulation) const { return countOf(simulation) == contents_; }

  /// A piece of the vectors.
  struct Piece {
    std::string name;
    bool isFree = false;
    std::size_t position = 0, positions = 0;
    std::size_t velocity = 0, velocities = 0;
    /// Which of the top-level models it belongs to.
    std::size_t model = 0;
  };
  const std::vector<Piece>& pieces() const { return pieces_; }
  std::size_t positionCount() const { return positionCount_; }
  std::size_t velocityCount() const { return velocityCount_; }

  void readPositions(std::span<double> to) const;
  void readVelocities(std::span<double> to) const;
  /// Sets what differs from what is there now, in an order in which nothing undoes what is set before. Without
  /// velocities, they keep their numbers. Raises ValueError for numbers that are not finite and quaternions that are
  /// not of length 1, and Refused, when what was set already is put back but for rounding.
  void write(std::optional<std::span<const double>> positions, std::optional<std::span<const double>> velocities);

 private:
  /// Bodies that move together, free of the world.
  struct Free {
    Link link;
    /// Set if the whole model moves.
    std::optional<Model> model;
    /// Whether it can be set: it is a whole model, or a link without joints.
    bool canBeSet;

    Pose pose() const;
    Twist velocity() const;
    Outcome<void> setPose(const Pose& pose);
    void setVelocity(const Twist& twist);
    /// @throws Refused if it can't be set.
    void checkCanBeSet(const std::string& name) const;
  };
  static std::vector<std::uint64_t> countOf(Simulation& simulation);
  void add(const Model& top, std::size_t number, const std::vector<Free>& free);
  /// Calls a function with each free piece and what it is, in order.
  template <class Function>
  void forEachFree(Function function);
  /// Sets the axes of joints whose number differs.
  /// @param place Where a piece's numbers begin.
  void setJoints(std::span<const double> numbers, std::size_t Piece::*place, double (Joint::*now)(int) const,
                 Outcome<void> (Joint::*set)(double, int));
  void setPositions(std::span<const double> positions);
  /// Stops the models of which a joint is to move: otherwise velocities would rotate with what it moves, and the joints
  /// would be torn apart by what they were before.
  void stopWhatMoves(std::span<const double> positions);
  void setVelocities(std::span<const double> velocities);

  std::vector<std::uint64_t> contents_;
  std::vector<Piece> pieces_;
  /// In the order of the pieces that they are.
  std::vector<Free> free_;
  std::vector<Joint> joints_;
  std::size_t positionCount_ = 0;
  std::size_t velocityCount_ = 0;
};

/// @return Zero for a model without links.
Twist velocityOf(const Model& model);

/// Binds the state as vectors, and what sets many models at once.
void bindState(py::class_<Owner>& simulation);

}  // namespace pongsim::python
