#include "cli/model/sensor_text.hh"

#include <array>
#include <cstddef>
#include <cstdio>
#include <utility>
#include <variant>

namespace pongsim::cli {

namespace {

/// Formatted like C++ streams.
std::string streamed(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

class SettingsPrinter {
 public:
  explicit SettingsPrinter(int indent) : indent_(static_cast<std::size_t>(indent)) {}

  void operator()(const AirPressureSettings& settings) {
    line("Reference altitude (m)", settings.referenceAltitude);
    noise("Pressure noise", settings.pressure, "Pa");
  }

  void operator()(const AltimeterSettings& settings) {
    noise("Vertical position noise", settings.verticalPosition, "m");
    noise("Vertical velocity noise", settings.verticalVelocity, "m/s");
  }

  void operator()(const CameraSettings& settings) {
    line("Horizontal field of view (rad)", settings.horizontalFov);
    line("Image width (px)", settings.width);
    line("Image height (px)", settings.height);
    line("Near clip (m)", settings.clip.near);
    line("Far clip (m)", settings.clip.far);
    line("Save frames", settings.savesPictures ? 1 : 0);
    add("- Save frames path: " + settings.savePath);
  }

  void operator()(const ImuSettings& settings) {
    noise3("Linear acceleration ", settings.linearAcceleration, "m/s^2");
    noise3("Angular velocity ", settings.angularVelocity, "rad/s");
    add("- Localization:" + settings.localization);
    const Vector3 angles = rollPitchYawOf(settings.customRotation);
    add("- Custom RPY: " + streamed(angles.x()) + " " + streamed(angles.y()) + " " + streamed(angles.z()));
  }

  void operator()(const LidarSettings& settings) {
    add("- Range:");
    indent_ += 2;
    line("Min (m)", settings.minRange);
    line("Max (m)", settings.maxRange);
    line("Resolution", settings.rangeResolution);
    indent_ -= 2;
    scan("Horizontal scan", settings.horizontal);
    scan("Vertical scan", settings.vertical);
    noise("Noise", settings.noise, "m");
  }

  void operator()(const MagnetometerSettings& settings) { noise3("", settings.field, "T"); }

  template <class Other>
  void operator()(const Other&) {}

  std::string text() && { return std::move(text_); }

 private:
  void add(const std::string& line) { text_ += std::string(indent_, ' ') + line + "\n"; }
  void line(const std::string& what, double value) { add("- " + what + ": " + streamed(value)); }

  void scan(const std::string& what, const LidarSettings::Scan& scan) {
    add("- " + what + ":");
    indent_ += 2;
    line("Samples", scan.samples);
    line("Resolution", scan.resolution);
    line("Min angle (rad)", scan.minAngle);
    line("Max angle (rad)", scan.maxAngle);
    indent_ -= 2;
  }

  void noise(const std::string& what, const NoiseSettings& noise, const std::string& unit) {
    const std::string inUnit = " (" + unit + ")";
    add("- " + what + ":");
    indent_ += 2;
    line("Mean" + inUnit, noise.mean);
    line("Bias mean" + inUnit, noise.biasMean);
    line("Standard deviation" + inUnit, noise.standardDeviation);
    line("Bias standard deviation" + inUnit, noise.biasStandardDeviation);
    line("Precision", noise.precision);
    line("Dynamic bias standard deviation" + inUnit, noise.dynamicBiasStandardDeviation);
    line("Dynamic bias correlation time (s)", noise.dynamicBiasCorrelationTime);
    indent_ -= 2;
  }

  void noise3(const std::string& what, const NoiseSettings3& axes, const std::string& unit) {
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
      noise(what + "XYZ"[axis] + "-axis noise", axes[axis], unit);
    }
  }

  std::size_t indent_;
  std::string text_;
};

}  // namespace

std::string sensorText(const SensorSettings& settings, int indent) {
  SettingsPrinter printer(indent);
  std::visit(printer, settings);
  return std::move(printer).text();
}

}  // namespace pongsim::cli
