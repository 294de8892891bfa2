#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "pongsim/sensing/camera_settings.hh"
#include "pongsim/sensing/noise_settings.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// `<imu>`
struct ImuSettings {
  /// [rad/s]
  NoiseSettings3 angularVelocity;
  /// [m/s^2]
  NoiseSettings3 linearAcceleration;
  bool enableOrientation = true;
  /// Reference of the orientation: "ENU", "NED", "NWU", "CUSTOM" or one that Fortress accepts and ignores; empty: the
  /// sensor's orientation at the start.
  std::string localization;
  /// For "CUSTOM": the reference orientation, in the world frame rotated by its heading.
  Quaternion customRotation = Quaternion::Identity();
  bool operator==(const ImuSettings&) const = default;
};

/// `<contact>`. Its topic is the sensor's.
struct ContactSettings {
  /// Names of collisions of the sensor's link.
  std::vector<std::string> collisions;
  bool operator==(const ContactSettings&) const = default;
};

/// `<altimeter>`
struct AltimeterSettings {
  /// [m]
  NoiseSettings verticalPosition;
  /// [m/s]
  NoiseSettings verticalVelocity;
  bool operator==(const AltimeterSettings&) const = default;
};

/// `<air_pressure>`
struct AirPressureSettings {
  /// `<reference_altitude>` [m], which Fortress reads but does not use.
  double referenceAltitude = 0;
  /// [Pa]
  NoiseSettings pressure;
  bool operator==(const AirPressureSettings&) const = default;
};

/// `<magnetometer>`
struct MagnetometerSettings {
  /// [T]
  NoiseSettings3 field;
  bool operator==(const MagnetometerSettings&) const = default;
};

/// `<force_torque>`
struct ForceTorqueSettings {
  /// Frame of the values.
  enum class Frame { kChild, kParent, kSensor };
  Frame frame = Frame::kChild;
  /// Measures the wrench of the parent on the child, instead of that of the child on the parent.
  bool isParentToChild = false;
  /// [N]
  NoiseSettings3 force;
  /// [N m]
  NoiseSettings3 torque;
  bool operator==(const ForceTorqueSettings&) const = default;
};

/// `<lidar>` or `<ray>`: beams from the sensor's origin, with horizontal angles about z from x, and vertical angles
/// upwards.
struct LidarSettings {
  struct Scan {
    /// At least one.
    std::uint32_t samples = 1;
    /// The number of beams is `samples` times this, at least one.
    double resolution = 1;
    /// [rad]
    double minAngle = 0;
    double maxAngle = 0;
    bool operator==(const Scan&) const = default;
  };
  Scan horizontal{.samples = 640};
  Scan vertical;
  /// [m]
  double minRange = 0;
  /// [m], may be infinite.
  double maxRange = 0;
  /// [m] As in Fortress, ranges are not rounded to it.
  double rangeResolution = 0;
  /// [m]
  NoiseSettings noise;
  /// A visual is visible if it shares a bit with its visibility flags.
  std::uint32_t visibilityMask = 0xFFFFFFFF;
  bool operator==(const LidarSettings&) const = default;
};

/// `<navsat>` or `<gps>`
struct NavSatSettings {
  /// [degrees], as in Fortress.
  NoiseSettings horizontalPosition;
  /// [m]
  NoiseSettings verticalPosition;
  /// [m/s]
  NoiseSettings horizontalVelocity;
  NoiseSettings verticalVelocity;
  bool operator==(const NavSatSettings&) const = default;
};

/// `<logical_camera>`: models within a frustum along x.
struct LogicalCameraSettings {
  /// [m]
  double near = 0;
  double far = 1;
  /// [rad]
  double horizontalFov = 1;
  /// Width divided by height.
  double aspectRatio = 1;
  bool operator==(const LogicalCameraSettings&) const = default;
};

/// `<sonar>`
struct SonarSettings {
  enum class Shape { kCone, kSphere };
  Shape shape = Shape::kCone;
  /// [m]
  double minRange = 0;
  double maxRange = 1;
  /// Of the cone at its maximum range [m].
  double radius = 0.5;
  bool operator==(const SonarSettings&) const = default;
};

/// `<transceiver>`, of wireless receivers and transmitters.
struct TransceiverSettings {
  std::string essid = "wireless";
  /// Frequency of a transmitter, and frequency range of a receiver [MHz].
  double frequency = 2442;
  double minFrequency = 2412;
  double maxFrequency = 2484;
  /// Antenna gain [dBi].
  double gain = 2.5;
  /// [dBm]
  double power = 14.5;
  double sensitivity = -90;
  bool operator==(const TransceiverSettings&) const = default;
};

/// Settings by sensor type; empty for types without any, such as "rfid", and for unknown types.
using SensorSettings =
    std::variant<std::monostate, ImuSettings, ContactSettings, AltimeterSettings, AirPressureSettings,
                 MagnetometerSettings, ForceTorqueSettings, CameraSettings, LidarSettings, NavSatSettings,
                 LogicalCameraSettings, SonarSettings, TransceiverSettings>;

}  // namespace pongsim
