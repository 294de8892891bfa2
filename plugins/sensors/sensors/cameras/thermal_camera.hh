#pragma once

#include <ignition/msgs/image.pb.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "camera_body.hh"
#include "pongsim/bulk.hh"
#include "pongsim/sensing/noise.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

/// A camera for temperatures: images of 16 bits (L16), or 8 bits (L8), with the temperature divided by the resolution.
class ThermalCamera final : public CameraOf<ignition::msgs::Image> {
 public:
  /// @throws Error if its settings are not supported, or it has too many pixels.
  ThermalCamera(const SensorContext& context, CameraSurroundings& surroundings);

  void measure() override;
  std::optional<Bulk> bulk() override;
  bool isHeardElsewhere() const override { return body_.isInfoHeard() || body_.saves(); }
  void publishElsewhere() override;

 private:
  void write(std::span<std::byte> to) const;
  /// @return The image in grey from its coldest to its hottest pixel; three bytes each.
  std::vector<std::uint8_t> shades() const;

  const SensorTopic& topic_;
  Noise& noise_;
  bool hasEightBits_;
  /// [K] per unit.
  double resolution_;
  /// [K]
  std::vector<float> temperatures_;
  /// In units of the resolution; empty before the first image.
  std::vector<std::uint16_t> values_;
};

}  // namespace pongsim
