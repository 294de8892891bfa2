#include "golden/corridor.hh"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace pongsim::test {

std::vector<Sample> readSamples(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  std::vector<Sample> samples;
  while (std::getline(stream, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream columns(line);
    double seconds = 0, x = 0, y = 0, z = 0;
    columns >> seconds >> x >> y >> z;
    samples.push_back({fromSeconds(seconds), {x, y, z}});
  }
  return samples;
}

void expectWithinCorridor(const std::vector<Sample>& samples, const Vector3& start,
                          const std::function<Vector3(Time)>& positionAt) {
  ASSERT_EQ(samples.size(), 100U);
  double distance = 0;
  double largest = 0;
  Vector3 last = start;
  for (const Sample& sample : samples) {
    distance += (sample.position - last).norm();
    last = sample.position;
    const double deviation = (positionAt(sample.time) - sample.position).norm();
    EXPECT_LT(deviation, std::max(0.02 * distance, 0.005))
        << "after " << toSeconds(sample.time) << " s and " << distance << " m";
    largest = std::max(largest, deviation);
  }
  testing::Test::RecordProperty("largest_deviation_mm", std::to_string(1000 * largest));
}

}  // namespace pongsim::test
