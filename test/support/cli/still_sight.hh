#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/view/sight.hh"

namespace pongsim::test {

/// A world that stands still, and in which there is nothing; for tests that override what they need.
class StillSight : public cli::Sight {
 public:
  std::vector<std::string> names() override { return {}; }
  Eigen::AlignedBox3d bounds(const std::string&) override { return {}; }
  std::optional<Vector3> position(const std::string&) override { return std::nullopt; }
  std::optional<Time> advance(Time time) override { return time; }
  void drawColors(const PictureView&, std::span<std::uint8_t>) override {}
  void drawDepths(const PictureView&, std::span<float>) override {}
  void drawTemperatures(const PictureView&, std::span<float>) override {}
  void drawNumbers(const PictureView&, std::span<std::uint32_t>) override {}
  std::span<const SeenVisual> visuals() override { return {}; }
};

}  // namespace pongsim::test
