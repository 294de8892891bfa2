#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "pongsim/camera_settings.hh"
#include "pongsim/noise_settings.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// `<imu>`
struct ImuSettings {
  /// [rad/s]
  NoiseSettings3 angularVelocity;
  /// [m/s^2]
  NoiseSettings3 linearAcceleration;
  bool enableOrientation = true;
  /// What the orientation is measured in: "ENU", "NED", "NWU", "CUSTOM" or one that Fortress takes and ignores; empty:
  /// the sensor's own orientation at the start.
  std::string localization;
  /// With "CUSTOM": orientation of what the orientation is measured in, in the world frame turned by its heading.
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
  /// `<reference_altitude>` [m], which Fortress reads and does not use.
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
  /// Whose axes the values are given in.
  enum class Frame { kChild, kParent, kSensor };
  Frame frame = Frame::kChild;
  /// What the parent does to the child is measured, in place of what the child does to the parent.
  bool isParentToChild = false;
  /// [N]
  NoiseSettings3 force;
  /// [N m]
  NoiseSettings3 torque;
  bool operator==(const ForceTorqueSettings&) const = default;
};

/// `<lidar>` or `<ray>`: beams from the sensor's origin, horizontal angles about z from x, vertical ones up from there.
struct LidarSettings {
  struct Scan {
    /// At least one.
    std::uint32_t samples = 1;
    /// Times `samples` is the number of beams, as long as that is one at least.
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
  /// [m], perhaps infinite.
  double maxRange = 0;
  /// [m] As in Fortress no range is rounded to it.
  double rangeResolution = 0;
  /// [m]
  NoiseSettings noise;
  /// A visual is seen where one of these bits is in its visibility flags.
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
  /// Width by height.
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
  /// Of the cone at its farthest [m].
  double radius = 0.5;
  bool operator==(const SonarSettings&) const = default;
};

/// `<transceiver>`, of wireless receivers and transmitters.
struct TransceiverSettings {
  std::string essid = "wireless";
  /// Of what a transmitter sends, and between which a receiver hears [MHz].
  double frequency = 2442;
  double minFrequency = 2412;
  double maxFrequency = 2484;
  /// Of the antenna [dBi].
  double gain = 2.5;
  /// [dBm]
  double power = 14.5;
  double sensitivity = -90;
  bool operator==(const TransceiverSettings&) const = default;
};

/// What the element of a sensor's own type says; nothing of types that have none, as "rfid", or that nobody knows.
using SensorSettings =
    std::variant<std::monostate, ImuSettings, ContactSettings, AltimeterSettings, AirPressureSettings,
                 MagnetometerSettings, ForceTorqueSettings, CameraSettings, LidarSettings, NavSatSettings,
                 LogicalCameraSettings, SonarSettings, TransceiverSettings>;

}  // namespace pongsim
