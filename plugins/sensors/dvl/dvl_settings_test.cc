#include "dvl_settings.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pongsim::dvl_settings_test {
namespace {

using std::numbers::pi;

TEST(DvlSettings, FillACone) {
  const double resolution = 0.01;
  for (const double aperture : {0.01, 0.02, 0.1, 0.5}) {
    DvlBeam beam;
    beam.aperture = aperture;
    beam.axis = Vector3(0.5, 0, -std::sqrt(0.75));
    const std::vector<Vector3> rays = raysOf(beam, resolution);
    // each has about a square of resolution^2 of the cone's 2 pi (1 - cos(aperture / 2))
    const double expected = 2 * pi * (1 - std::cos(aperture / 2)) / (resolution * resolution);
    EXPECT_NEAR(static_cast<double>(rays.size()), expected, 1 + 2 * pi * aperture / 2 / resolution) << aperture;
    double widest = 0;
    for (const Vector3& ray : rays) {
      EXPECT_NEAR(ray.norm(), 1, 1e-12);
      widest = std::max(widest, std::acos(std::min(1.0, ray.dot(beam.axis))));
    }
    EXPECT_LT(widest, aperture / 2);
    EXPECT_GE(widest, aperture / 2 - resolution - 1e-7);
  }
}

}  // namespace
}  // namespace pongsim::dvl_settings_test
