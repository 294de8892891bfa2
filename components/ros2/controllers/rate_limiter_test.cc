#include "ros2/controllers/rate_limiter.hh"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ros2/node/parameters.hh"

namespace pongsim::ros2 {
namespace {

constexpr double kDt = 0.01;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

RateLimits limitsOf(const std::map<std::string, double>& given, std::vector<std::string>* errors = nullptr) {
  ParameterValues values;
  for (const auto& [name, value] : given) values["x." + name] = parameterOf(value);
  ControllerParameters parameters(values);
  const RateLimits limits = RateLimits::read(parameters, "x");
  if (errors != nullptr) *errors = parameters.errors();
  return limits;
}

TEST(RateLimiter, LimitsNothingWithoutLimits) { EXPECT_EQ(RateLimiter().limit(50, 0, 0, kDt), 50); }

TEST(RateLimiter, LimitsTheVelocityInBothDirectionsByTheUpperLimitAlone) {
  const RateLimiter limiter(limitsOf({{"max_velocity", 2}}));
  EXPECT_EQ(limiter.limit(5, 0, 0, kDt), 2);
  EXPECT_EQ(limiter.limit(-5, 0, 0, kDt), -2);
  const RateLimiter uneven(limitsOf({{"max_velocity", 2}, {"min_velocity", -0.5}}));
  EXPECT_EQ(uneven.limit(-5, 0, 0, kDt), -0.5);
}

TEST(RateLimiter, AcceleratesAndDeceleratesByTheirOwnLimits) {
  const RateLimiter limiter(limitsOf({{"max_acceleration", 1},
                                      {"max_deceleration", -4},
                                      {"max_acceleration_reverse", -2},
                                      {"max_deceleration_reverse", 8}}));
  EXPECT_NEAR(limiter.limit(5, 0, 0, kDt), 0.01, 1e-12);
  EXPECT_NEAR(limiter.limit(5, 1, 1, kDt), 1.01, 1e-12);
  EXPECT_NEAR(limiter.limit(0, 1, 1, kDt), 0.96, 1e-12);
  EXPECT_NEAR(limiter.limit(-5, 0, 0, kDt), -0.02, 1e-12);
  EXPECT_NEAR(limiter.limit(0, -1, -1, kDt), -0.92, 1e-12);
}

TEST(RateLimiter, TakesHumblesNamesAndSwitches) {
  const RateLimiter limiter(limitsOf({{"max_acceleration", 1}, {"min_acceleration", -3}}));
  EXPECT_NEAR(limiter.limit(0, 1, 1, kDt), 0.97, 1e-12);
  ParameterValues values{{"x.max_velocity", parameterOf(1.0)}, {"x.has_velocity_limits", parameterOf(false)}};
  ControllerParameters parameters(values);
  EXPECT_EQ(RateLimiter(RateLimits::read(parameters, "x")).limit(5, 0, 0, kDt), 5);
}

TEST(RateLimiter, LimitsTheJerkOnlyWhereTheSpeedGrows) {
  const RateLimiter limiter(limitsOf({{"max_jerk", 100}}));
  // the change of the change is at most 100 dt^2
  EXPECT_NEAR(limiter.limit(5, 0, 0, kDt), 0.01, 1e-12);
  EXPECT_NEAR(limiter.limit(5, 0.01, 0, kDt), 0.03, 1e-12);
  EXPECT_NEAR(limiter.limit(0.5, 0.5, 0.4, kDt), 0.5, 1e-12);
}

TEST(RateLimiter, RefusesLimitsThatContradict) {
  std::vector<std::string> errors;
  limitsOf({{"max_velocity", 1}, {"min_velocity", 2}}, &errors);
  EXPECT_EQ(errors, std::vector<std::string>{"'x': the lower limit of its velocity is above the upper"});
  limitsOf({{"max_velocity", kNaN}, {"min_velocity", 2}}, &errors);
  EXPECT_TRUE(errors.empty());
}

}  // namespace
}  // namespace pongsim::ros2
