#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sdf/sdf.hh>
#include <string>
#include <vector>

#include "description/color.hh"
#include "pongsim/types.hh"

namespace pongsim::test {

namespace theirs = ::sdf;
namespace ours = pongsim::description;

constexpr double kTolerance = 1e-9;

/// libsdformat takes minutes and gigabytes for larger files.
constexpr std::uintmax_t kMostBytes = 1'000'000;

inline Vector3 vector(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }

inline Pose pose(const ignition::math::Pose3d& X) {
  return {vector(X.Pos()), Quaternion(X.Rot().W(), X.Rot().X(), X.Rot().Y(), X.Rot().Z())};
}

template <class Thing>
Pose resolved(const Thing& thing, const std::string& to = "") {
  ignition::math::Pose3d result;
  const theirs::Errors errors = thing.SemanticPose().Resolve(result, to);
  EXPECT_TRUE(errors.empty()) << errors.front();
  return pose(result);
}

inline void expectNear(double a, double b, const std::string& what) {
  const auto limited = [](double value) { return std::clamp(value, -1e16, 1e16); };
  EXPECT_LE(std::abs(limited(a) - limited(b)), kTolerance * std::max(1.0, std::abs(limited(b))))
      << what << ": " << a << " and " << b;
}

inline void expectNear(const Vector3& a, const Vector3& b, const std::string& what) {
  EXPECT_LE((a - b).norm(), kTolerance * std::max(1.0, b.norm()))
      << what << ": " << a.transpose() << " and " << b.transpose();
}

inline void expectNear(const Pose& a, const Pose& b, const std::string& what) {
  expectNear(a.position, b.position, what);
  EXPECT_LE(2 * (a.rotation.conjugate() * b.rotation).vec().norm(), kTolerance)
      << what << ": " << a.rotation.coeffs().transpose() << " and " << b.rotation.coeffs().transpose();
}

inline void expectNear(const ours::Color& a, const ignition::math::Color& b, const std::string& what) {
  EXPECT_EQ(a.red, b.R()) << what;
  EXPECT_EQ(a.green, b.G()) << what;
  EXPECT_EQ(a.blue, b.B()) << what;
  EXPECT_EQ(a.alpha, b.A()) << what;
}

/// @return The one with this name, or null.
template <class Thing>
const Thing* named(const std::vector<Thing>& things, const std::string& name) {
  const auto found = std::ranges::find(things, name, &Thing::name);
  return found == things.end() ? nullptr : &*found;
}

}  // namespace pongsim::test
