#include "joint_faults.hh"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "pongsim/outcome.hh"

namespace pongsim::faults {

namespace {

void report(const Outcome<void>& done, const Logger& log) {
  if (!done) log.warning("a fault can't act: " + done.error);
}

// Infinity, of which a saved state has none.
constexpr double kEndless = StateArchive::kLargestNumber;

double finite(double number) { return std::clamp(number, -kEndless, kEndless); }

double bound(double number) {
  if (std::abs(number) < kEndless) return number;
  return number < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

}  // namespace

JointFault::JointFault(const World& world, const Joint& joint, const Fault& fault)
    : properties_(world), joint_(joint), fault_(fault) {}

void JointFault::update(Time now, const Logger& log) {
  if (!joint_.exists() || fault_.isActive(now) == isOn_) return;
  isOn_ = !isOn_;
  if (isOn_) {
    begin(log);
  } else {
    end(log);
  }
}

void JointFault::begin(const Logger& log) {
  before_.clear();
  if (fault_.kind == Kind::kSlip) {
    for (const Collision& collision : joint_.child().collisions()) {
      PhysicalProperties::Surface surface = properties_.surface(collision);
      before_.insert(before_.end(), {surface.friction, surface.friction2});
      surface.friction *= fault_.friction;
      surface.friction2 *= fault_.friction;
      report(properties_.setSurface(collision, surface), log);
    }
    return;
  }
  for (int axis = 0; axis < joint_.axisCount(); ++axis) {
    PhysicalProperties::Bounds bounds = properties_.bounds(joint_, axis);
    if (fault_.kind == Kind::kStick) {
      before_.insert(before_.end(), {finite(bounds.lower), finite(bounds.upper)});
      bounds.lower = bounds.upper = joint_.position(axis);
    } else {
      before_.insert(before_.end(), {finite(bounds.effort), 0});
      bounds.effort = fault_.effort ? std::min(*fault_.effort, bounds.effort) : bounds.effort * *fault_.factor;
    }
    report(properties_.setBounds(joint_, bounds, axis), log);
  }
}

void JointFault::end(const Logger& log) {
  std::size_t next = 0;
  if (fault_.kind == Kind::kSlip) {
    for (const Collision& collision : joint_.child().collisions()) {
      PhysicalProperties::Surface surface = properties_.surface(collision);
      surface.friction = before_[next++];
      surface.friction2 = before_[next++];
      report(properties_.setSurface(collision, surface), log);
    }
    return;
  }
  for (int axis = 0; axis < joint_.axisCount(); ++axis) {
    PhysicalProperties::Bounds bounds = properties_.bounds(joint_, axis);
    const double first = bound(before_[next++]);
    const double second = bound(before_[next++]);
    if (fault_.kind == Kind::kStick) {
      bounds.lower = first;
      bounds.upper = second;
    } else {
      bounds.effort = first;
    }
    report(properties_.setBounds(joint_, bounds, axis), log);
  }
}

void JointFault::transfer(StateArchive& archive) {
  archive(isOn_);
  archive(before_);
  if (!joint_.exists()) return;
  const std::size_t parts =
      fault_.kind == Kind::kSlip ? joint_.child().collisions().size() : static_cast<std::size_t>(joint_.axisCount());
  archive.check(!isOn_ || before_.size() == 2 * parts);
}

}  // namespace pongsim::faults
