#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ros2/types/std_msgs.hh"

namespace pongsim::ros2::gps_msgs {

struct GPSStatus {
  static constexpr const char* kName = "gps_msgs/msg/GPSStatus";
  static constexpr std::int16_t kStatusNoFix = -1;
  static constexpr std::int16_t kStatusFix = 0;
  static constexpr std::int16_t kStatusSbasFix = 1;
  static constexpr std::int16_t kStatusGbasFix = 2;
  static constexpr std::int16_t kStatusDgpsFix = 18;
  static constexpr std::int16_t kStatusRtkFix = 19;
  static constexpr std::int16_t kStatusRtkFloat = 20;
  static constexpr std::int16_t kStatusWaasFix = 33;
  static constexpr std::uint16_t kSourceNone = 0;
  static constexpr std::uint16_t kSourceGps = 1;
  static constexpr std::uint16_t kSourcePoints = 2;
  static constexpr std::uint16_t kSourceDoppler = 4;
  static constexpr std::uint16_t kSourceAltimeter = 8;
  static constexpr std::uint16_t kSourceMagnetic = 16;
  static constexpr std::uint16_t kSourceGyro = 32;
  static constexpr std::uint16_t kSourceAccel = 64;
  std_msgs::Header header;
  std::uint16_t satellites_used = 0;
  std::vector<std::int32_t> satellite_used_prn;
  std::uint16_t satellites_visible = 0;
  std::vector<std::int32_t> satellite_visible_prn;
  std::vector<std::int32_t> satellite_visible_z;
  std::vector<std::int32_t> satellite_visible_azimuth;
  std::vector<std::int32_t> satellite_visible_snr;
  std::int16_t status = 0;
  std::uint16_t motion_source = 0;
  std::uint16_t orientation_source = 0;
  std::uint16_t position_source = 0;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("satellites_used", self.satellites_used);
    field("satellite_used_prn", self.satellite_used_prn);
    field("satellites_visible", self.satellites_visible);
    field("satellite_visible_prn", self.satellite_visible_prn);
    field("satellite_visible_z", self.satellite_visible_z);
    field("satellite_visible_azimuth", self.satellite_visible_azimuth);
    field("satellite_visible_snr", self.satellite_visible_snr);
    field("status", self.status);
    field("motion_source", self.motion_source);
    field("orientation_source", self.orientation_source);
    field("position_source", self.position_source);
  }
  bool operator==(const GPSStatus&) const = default;
};

struct GPSFix {
  static constexpr const char* kName = "gps_msgs/msg/GPSFix";
  static constexpr std::uint8_t kCovarianceTypeUnknown = 0;
  static constexpr std::uint8_t kCovarianceTypeApproximated = 1;
  static constexpr std::uint8_t kCovarianceTypeDiagonalKnown = 2;
  static constexpr std::uint8_t kCovarianceTypeKnown = 3;
  std_msgs::Header header;
  GPSStatus status;
  double latitude = 0;
  double longitude = 0;
  double altitude = 0;
  double track = 0;
  double speed = 0;
  double climb = 0;
  double pitch = 0;
  double roll = 0;
  double dip = 0;
  double time = 0;
  double gdop = 0;
  double pdop = 0;
  double hdop = 0;
  double vdop = 0;
  double tdop = 0;
  double err = 0;
  double err_horz = 0;
  double err_vert = 0;
  double err_track = 0;
  double err_speed = 0;
  double err_climb = 0;
  double err_time = 0;
  double err_pitch = 0;
  double err_roll = 0;
  double err_dip = 0;
  std::array<double, 9> position_covariance{};
  std::uint8_t position_covariance_type = 0;
  static void visit(auto& self, auto&& field) {
    field("header", self.header);
    field("status", self.status);
    field("latitude", self.latitude);
    field("longitude", self.longitude);
    field("altitude", self.altitude);
    field("track", self.track);
    field("speed", self.speed);
    field("climb", self.climb);
    field("pitch", self.pitch);
    field("roll", self.roll);
    field("dip", self.dip);
    field("time", self.time);
    field("gdop", self.gdop);
    field("pdop", self.pdop);
    field("hdop", self.hdop);
    field("vdop", self.vdop);
    field("tdop", self.tdop);
    field("err", self.err);
    field("err_horz", self.err_horz);
    field("err_vert", self.err_vert);
    field("err_track", self.err_track);
    field("err_speed", self.err_speed);
    field("err_climb", self.err_climb);
    field("err_time", self.err_time);
    field("err_pitch", self.err_pitch);
    field("err_roll", self.err_roll);
    field("err_dip", self.err_dip);
    field("position_covariance", self.position_covariance);
    field("position_covariance_type", self.position_covariance_type);
  }
  bool operator==(const GPSFix&) const = default;
};

}  // namespace pongsim::ros2::gps_msgs
