#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "pongsim/types.hh"

namespace pongsim {

/// How a value is falsified, as `<noise>` says. All but the times in the unit of the value.
struct NoiseSettings {
  enum class Type { kNone, kGaussian, kGaussianQuantized };
  Type type = Type::kNone;
  double mean = 0;
  double standardDeviation = 0;
  /// Of an offset that is drawn once, its sign too.
  double biasMean = 0;
  double biasStandardDeviation = 0;
  /// Of an offset that wanders, and the time in which it does [s]; it stands still where one of them is zero.
  double dynamicBiasStandardDeviation = 0;
  double dynamicBiasCorrelationTime = 0;
  /// With `kGaussianQuantized` the result is a multiple of it; zero: it is not rounded.
  double precision = 0;
  bool operator==(const NoiseSettings&) const = default;
};

/// Noise along x, y and z.
using NoiseSettings3 = std::array<NoiseSettings, 3>;

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

/// `<navsat>`
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

/// `<logical_camera>`: a pyramid along the sensor's x axis, without its top.
struct LogicalCameraSettings {
  /// From where to where it sees [m].
  double near = 0;
  double far = 1;
  /// Width by height.
  double aspectRatio = 1;
  /// [rad]
  double horizontalFov = 1;
  bool operator==(const LogicalCameraSettings&) const = default;
};

/// What the element of a sensor's own type says.
using SensorSettings =
    std::variant<std::monostate, ImuSettings, ContactSettings, AltimeterSettings, AirPressureSettings,
                 MagnetometerSettings, ForceTorqueSettings, NavSatSettings, LogicalCameraSettings>;

}  // namespace pongsim
