#pragma once

#include <ignition/msgs/image.pb.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "camera_body.hh"
#include "pongsim/bulk.hh"
#include "pongsim/node.hh"
#include "pongsim/sensing/label_colors.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

/// A camera for labels: a map with a colour for each label or instance, and a map with their numbers.
class SegmentationCamera final : public CameraOf<ignition::msgs::Image> {
 public:
  /// Kind of the readings with the map of numbers.
  static constexpr const char* kLabels = "labels";

  /// @throws Error if its settings are not supported, or it has too many pixels.
  SegmentationCamera(const SensorContext& context, CameraSurroundings& surroundings);

  void measure() override;
  std::optional<Bulk> bulk() override;
  bool isHeardElsewhere() const override { return body_.isInfoHeard() || labels_.hasSubscribers() || body_.saves(); }
  void publishElsewhere() override;

 private:
  /// Writes one of the two maps, three bytes for each pixel.
  void write(LabelColor LabelLook::*map, std::span<std::uint8_t> to) const;
  Bulk bulkOf(LabelColor LabelLook::*map) const;
  void save(const std::filesystem::path& folder, std::uint64_t number);

  const SensorTopic& topic_;
  Publisher labels_;
  ignition::msgs::Image labelImage_;
  /// For each pixel as `CameraScene::drawNumbers`; empty before the first image.
  std::vector<std::uint32_t> numbers_;
  /// Of the visuals at that time; the first is the background.
  std::vector<LabelLook> looks_;
};

}  // namespace pongsim
