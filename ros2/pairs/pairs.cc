#include "ros2/pairs/pairs.hh"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace pongsim::ros2 {

namespace {

/// Levenshtein's.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

std::vector<Pair> collect() {
  std::vector<Pair> all;
  for (auto* const list : {basicPairs, geometryPairs, gzPairs, imagePairs, motionPairs, sensorPairs, visionPairs})
    std::ranges::move(list(), std::back_inserter(all));
  return all;
}

}  // namespace

std::span<const Pair> allPairs() {
  static const std::vector<Pair> all = collect();
  return all;
}

const Pair* findPair(std::string_view ros, std::string_view ignition) {
  const std::string name = messageTypeName(ignition).value_or(std::string(ignition));
  const auto found =
      std::ranges::find_if(allPairs(), [&](const Pair& each) { return each.ros == ros && each.ignition == name; });
  return found == allPairs().end() ? nullptr : &*found;
}

const Pair* defaultPair(std::string_view ignition) {
  const auto found =
      std::ranges::find_if(allPairs(), [&](const Pair& each) { return each.isDefault && each.ignition == ignition; });
  return found == allPairs().end() ? nullptr : &*found;
}

std::string nearestRosType(std::string_view name) {
  std::string nearest;
  std::size_t least = std::max<std::size_t>(name.size() / 3, 2) + 1;
  for (const Pair& each : allPairs()) {
    const std::size_t d = distance(name, each.ros);
    if (d >= least) continue;
    least = d;
    nearest = each.ros;
  }
  return nearest;
}

}  // namespace pongsim::ros2
