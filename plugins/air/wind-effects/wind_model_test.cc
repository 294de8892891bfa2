#include "wind_model.hh"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace pongsim::wind_model_test {
namespace {

constexpr double kStep = 1e-3;

Random stream() { return Random(1, "wind"); }

/// Runs on for so many steps of a millisecond.
Vector3 run(WindModel& model, const Vector3& mean, int steps, int from = 0,
            const std::function<void(const Vector3&)>& atEach = {}) {
  Vector3 wind = Vector3::Zero();
  for (int i = 1; i <= steps; ++i) {
    wind = model.update(mean, std::chrono::milliseconds(from + i), kStep);
    if (atEach) atEach(wind);
  }
  return wind;
}

TEST(WindModel, RisesWithItsTimeConstants) {
  WindSettings settings;
  settings.magnitude.riseTime = 2;
  settings.vertical.riseTime = 0.5;
  WindModel model(settings, stream());
  const Vector3 wind = run(model, {3, 4, -2}, 1000);
  // a low pass of steps is ahead by half a step
  const double share = 1 - std::exp(-0.5), verticalShare = 1 - std::exp(-2);
  EXPECT_NEAR((wind - Vector3(3 * share, 4 * share, -2 * verticalShare)).norm(), 0, 3e-3);
  EXPECT_NEAR(wind.head<2>().norm(), 5 * (1 - std::pow(1 - kStep / 2, 1000)), 1e-9);
}

TEST(WindModel, TurnsToANewDirection) {
  WindSettings settings;
  settings.magnitude.riseTime = 1e-3;
  settings.direction.riseTime = 0.5;
  WindModel model(settings, stream());
  // the first one is there at once
  EXPECT_NEAR((run(model, {0, 5, 0}, 1) - Vector3(0, 5, 0)).norm(), 0, 1e-12);
  const Vector3 wind = run(model, {5, 0, 0}, 500, 1);
  EXPECT_NEAR(std::atan2(wind.y(), wind.x()), M_PI / 2 * std::exp(-1), 1e-3);
  EXPECT_NEAR(wind.norm(), 5, 1e-9);
}

TEST(WindModel, Waves) {
  WindSettings settings;
  settings.magnitude = {1e-3, 0.2, 4, {}};
  settings.direction = {1e-3, 30, 2, {}};
  WindModel model(settings, stream());
  run(model, {10, 0, 0}, 499);
  // a quarter of the direction's period, an eighth of the magnitude's
  Vector3 wind = run(model, {10, 0, 0}, 1, 499);
  EXPECT_NEAR(wind.norm(), 10 * (1 + 0.2 * std::sin(M_PI / 4)), 1e-9);
  EXPECT_NEAR(std::atan2(wind.y(), wind.x()), M_PI / 6, 1e-9);
  wind = run(model, {10, 0, 0}, 500, 500);
  EXPECT_NEAR((wind - Vector3(12, 0, 0)).norm(), 0, 1e-9);
}

TEST(WindModel, IsNotFasterThanItsStep) {
  WindSettings settings;
  settings.magnitude.riseTime = settings.vertical.riseTime = settings.direction.riseTime = 1e-6;
  WindModel model(settings, stream());
  EXPECT_NEAR((run(model, {3, 4, 5}, 1000) - Vector3(3, 4, 5)).norm(), 0, 1e-9);
}

/// Mean and standard deviation of a value.
struct Statistics {
  void add(double value) {
    sum += value;
    squares += value * value;
    ++count;
  }
  double mean() const { return sum / count; }
  double deviation() const { return std::sqrt(squares / count - mean() * mean()); }

  double sum = 0;
  double squares = 0;
  int count = 0;
};

NoiseSettings gaussian(double mean, double deviation) {
  return {.type = NoiseSettings::Type::kGaussian, .mean = mean, .standardDeviation = deviation};
}

TEST(WindModel, IsNoisy) {
  WindSettings settings;
  settings.magnitude = {1e-3, 0, 1, gaussian(0.5, 0.2)};
  settings.direction = {1e-3, 0, 1, gaussian(10, 3)};
  settings.vertical = {1e-3, 0, 1, gaussian(-0.1, 0.05)};
  WindModel model(settings, stream());
  Statistics magnitude, direction, vertical;
  constexpr int kCount = 20000;
  run(model, {10, 0, 1}, kCount, 0, [&](const Vector3& wind) {
    magnitude.add(wind.head<2>().norm());
    direction.add(std::atan2(wind.y(), wind.x()) * 180 / M_PI);
    vertical.add(wind.z());
  });
  // four times what a mean and a deviation of so many are uncertain by
  const auto expect = [](const Statistics& found, double mean, double deviation) {
    EXPECT_NEAR(found.mean(), mean, 4 * deviation / std::sqrt(kCount));
    EXPECT_NEAR(found.deviation(), deviation, 4 * deviation / std::sqrt(2 * kCount));
  };
  expect(magnitude, 10.5, 0.2);
  expect(direction, 10, 3);
  expect(vertical, 0.9, 0.05);
}

// what one part draws changes nothing for the others
TEST(WindModel, HasAStreamForEachPart) {
  WindSettings settings;
  settings.vertical.noise = gaussian(0, 1);
  WindModel alone(settings, stream());
  settings.magnitude.noise = settings.direction.noise = gaussian(0, 1);
  WindModel together(settings, stream());
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(run(alone, {1, 2, 3}, 1, i).z(), run(together, {1, 2, 3}, 1, i).z());
  }
}

TEST(WindModel, StartsAnewAndGoesOnFromASavedState) {
  WindSettings settings;
  settings.magnitude.noise = settings.direction.noise = settings.vertical.noise = {
      .type = NoiseSettings::Type::kGaussian, .standardDeviation = 1, .biasStandardDeviation = 1};
  WindModel model(settings, stream());
  const Vector3 first = run(model, {1, 2, 3}, 100);
  StateArchive taken;
  model.transfer(taken);
  const std::vector<std::byte> bytes = taken.take();
  const Vector3 second = run(model, {3, 2, 1}, 100, 100);

  model.reset(stream());
  EXPECT_EQ(run(model, {1, 2, 3}, 100), first);
  model.reset(stream());
  StateArchive given(bytes);
  model.transfer(given);
  EXPECT_EQ(run(model, {3, 2, 1}, 100, 100), second);
}

}  // namespace
}  // namespace pongsim::wind_model_test
