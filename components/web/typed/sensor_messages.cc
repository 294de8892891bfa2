#include "web/typed/sensor_messages.hh"

#include <foxglove/sensors.pb.h>
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/navsat.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <algorithm>

#include "web/typed/parts.hh"

namespace pongsim::web::typed {

namespace {

namespace im = ignition::msgs;
namespace fg = ::foxglove;

/// @return Foxglove's name of a format, the same as in ROS; null if there is none.
const char* encodingOf(im::PixelFormatType format) {
  switch (format) {
    case im::PixelFormatType::RGB_INT8:
      return "rgb8";
    case im::PixelFormatType::RGBA_INT8:
      return "rgba8";
    case im::PixelFormatType::BGR_INT8:
      return "bgr8";
    case im::PixelFormatType::BGRA_INT8:
      return "bgra8";
    case im::PixelFormatType::L_INT8:
      return "mono8";
    case im::PixelFormatType::L_INT16:
      return "mono16";
    case im::PixelFormatType::R_FLOAT32:
      return "32FC1";
    case im::PixelFormatType::BAYER_RGGB8:
      return "bayer_rggb8";
    case im::PixelFormatType::BAYER_GBRG8:
      return "bayer_gbrg8";
    case im::PixelFormatType::BAYER_GRBG8:
      return "bayer_grbg8";
    default:
      return nullptr;
  }
}

bool convert(im::Image& image, std::uint64_t timeNs, fg::RawImage& out) {
  const char* const encoding = encodingOf(image.pixel_format_type());
  if (encoding == nullptr) return false;
  fillIn(image.header(), timeNs, *out.mutable_timestamp());
  out.set_frame_id(frameOf(image.header()));
  out.set_width(image.width());
  out.set_height(image.height());
  out.set_encoding(encoding);
  out.set_step(image.step());
  out.set_data(std::move(*image.mutable_data()));
  return true;
}

bool convert(im::CameraInfo& info, std::uint64_t timeNs, fg::CameraCalibration& out) {
  fillIn(info.header(), timeNs, *out.mutable_timestamp());
  out.set_frame_id(frameOf(info.header()));
  out.set_width(info.width());
  out.set_height(info.height());
  switch (info.distortion().model()) {
    case im::CameraInfo::Distortion::PLUMB_BOB:
      out.set_distortion_model("plumb_bob");
      break;
    case im::CameraInfo::Distortion::RATIONAL_POLYNOMIAL:
      out.set_distortion_model("rational_polynomial");
      break;
    case im::CameraInfo::Distortion::EQUIDISTANT:
      out.set_distortion_model("kannala_brandt");
      break;
    default:
      return false;
  }
  *out.mutable_d() = info.distortion().k();
  *out.mutable_k() = info.intrinsics().k();
  *out.mutable_r() = info.rectification_matrix();
  *out.mutable_p() = info.projection().p();
  return true;
}

/// Of a lidar with several rows, the middle one, because Foxglove's scans are flat.
bool convert(im::LaserScan& scan, std::uint64_t timeNs, fg::LaserScan& out) {
  const auto count = static_cast<int>(scan.count());
  const int rows = std::max(1, static_cast<int>(scan.vertical_count()));
  if (count <= 0 || scan.ranges_size() / rows < count) return false;
  fillIn(scan.header(), timeNs, *out.mutable_timestamp());
  out.set_frame_id(frameOf(scan.header()).empty() ? scan.frame() : frameOf(scan.header()));
  out.mutable_pose()->mutable_orientation()->set_w(1);
  out.mutable_pose()->mutable_position();
  out.set_start_angle(scan.angle_min());
  out.set_end_angle(scan.angle_max());
  const int first = rows / 2 * count;
  for (int i = first; i < first + count; ++i) out.add_ranges(scan.ranges(i));
  if (scan.intensities_size() < first + count) return true;
  for (int i = first; i < first + count; ++i) out.add_intensities(scan.intensities(i));
  return true;
}

fg::PackedElementField::NumericType numericType(im::PointCloudPacked::Field::DataType type) {
  using Field = im::PointCloudPacked::Field;
  using Packed = fg::PackedElementField;
  switch (type) {
    case Field::INT8:
      return Packed::INT8;
    case Field::UINT8:
      return Packed::UINT8;
    case Field::INT16:
      return Packed::INT16;
    case Field::UINT16:
      return Packed::UINT16;
    case Field::INT32:
      return Packed::INT32;
    case Field::UINT32:
      return Packed::UINT32;
    case Field::FLOAT32:
      return Packed::FLOAT32;
    case Field::FLOAT64:
      return Packed::FLOAT64;
    default:
      return Packed::UNKNOWN;
  }
}

bool convert(im::PointCloudPacked& cloud, std::uint64_t timeNs, fg::PointCloud& out) {
  if (cloud.is_bigendian() || cloud.point_step() == 0) return false;
  fillIn(cloud.header(), timeNs, *out.mutable_timestamp());
  out.set_frame_id(frameOf(cloud.header()));
  out.mutable_pose()->mutable_orientation()->set_w(1);
  out.mutable_pose()->mutable_position();
  out.set_point_stride(cloud.point_step());
  for (const auto& field : cloud.field()) {
    auto& packed = *out.add_fields();
    packed.set_name(field.name());
    packed.set_offset(field.offset());
    packed.set_type(numericType(field.datatype()));
  }
  out.set_data(std::move(*cloud.mutable_data()));
  return true;
}

bool convert(im::NavSat& place, std::uint64_t timeNs, fg::LocationFix& out) {
  fillIn(place.header(), timeNs, *out.mutable_timestamp());
  out.set_frame_id(place.frame_id());
  out.set_latitude(place.latitude_deg());
  out.set_longitude(place.longitude_deg());
  out.set_altitude(place.altitude());
  return true;
}

template <class In, class Out>
Converted converted() {
  return {*Out::descriptor(), [](std::span<const std::byte> bytes, std::uint64_t timeNs) -> std::optional<std::string> {
            In in;
            Out out;
            if (!in.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())) || !convert(in, timeNs, out)) {
              return std::nullopt;
            }
            return out.SerializeAsString();
          }};
}

}  // namespace

std::optional<Converted> conversionOf(std::string_view type) {
  if (type == "ignition.msgs.Image") return converted<im::Image, fg::RawImage>();
  if (type == "ignition.msgs.CameraInfo") return converted<im::CameraInfo, fg::CameraCalibration>();
  if (type == "ignition.msgs.LaserScan") return converted<im::LaserScan, fg::LaserScan>();
  if (type == "ignition.msgs.PointCloudPacked") return converted<im::PointCloudPacked, fg::PointCloud>();
  if (type == "ignition.msgs.NavSat") return converted<im::NavSat, fg::LocationFix>();
  return std::nullopt;
}

}  // namespace pongsim::web::typed
