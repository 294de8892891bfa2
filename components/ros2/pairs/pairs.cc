#include "ros2/pairs/pairs.hh"

#include <algorithm>
#include <iterator>

namespace pongsim::ros2 {

namespace {

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

}  // namespace pongsim::ros2
