#include "description/particle_emitter.hh"

#include <gtest/gtest.h>

#include <limits>

namespace pongsim::description {
namespace {

TEST(ParticleEmitter, OfTheFormatsDefaultsIsValid) { EXPECT_EQ(faultOf(ParticleEmitter()), ""); }

TEST(ParticleEmitter, SaysWhichNumberIsInvalid) {
  ParticleEmitter emitter;
  emitter.rate = -1;
  EXPECT_EQ(faultOf(emitter), "its <rate> is not between 0 and 1e6");
  emitter = {};
  emitter.particleSize.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(faultOf(emitter), "its <particle_size> is not between 0 and 1e6");
  emitter = {};
  emitter.maxVelocity = 1e300;
  EXPECT_EQ(faultOf(emitter), "its <max_velocity> is not between -1e6 and 1e6");
  emitter = {};
  emitter.scatterRatio = 1.5;
  EXPECT_EQ(faultOf(emitter), "its <particle_scatter_ratio> is not between 0 and 1");
  emitter = {};
  emitter.colorEnd.green = 2;
  EXPECT_EQ(faultOf(emitter), "its <color_end> has a component that is not between 0 and 1");
}

}  // namespace
}  // namespace pongsim::description
