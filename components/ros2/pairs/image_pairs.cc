// images, clouds and camera_info, of sensor_msgs
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <algorithm>
#include <iterator>

#include "ros2/pairs/convert.hh"
#include "ros2/pairs/pairs.hh"
#include "ros2/types/sensor_msgs.hh"

namespace pongsim::ros2 {

namespace {

/// Both names of pixel formats, and their bytes per pixel.
struct ImageFormat {
  ignition::msgs::PixelFormatType type;
  std::string_view encoding;
  std::uint32_t bytes;
};
constexpr ImageFormat kImageFormats[] = {
    {ignition::msgs::L_INT8, "mono8", 1},
    {ignition::msgs::L_INT16, "mono16", 2},
    {ignition::msgs::RGB_INT8, "rgb8", 3},
    {ignition::msgs::RGBA_INT8, "rgba8", 4},
    {ignition::msgs::BGRA_INT8, "bgra8", 4},
    {ignition::msgs::RGB_INT16, "rgb16", 6},
    {ignition::msgs::BGR_INT8, "bgr8", 3},
    {ignition::msgs::BGR_INT16, "bgr16", 6},
    {ignition::msgs::R_FLOAT32, "32FC1", 4},
    {ignition::msgs::BAYER_RGGB8, "bayer_rggb8", 1},
    {ignition::msgs::BAYER_BGGR8, "bayer_bggr8", 1},
    {ignition::msgs::BAYER_GBRG8, "bayer_gbrg8", 1},
    {ignition::msgs::BAYER_GRBG8, "bayer_grbg8", 1},
};

struct ImagePair {
  using Ros = sensor_msgs::Image;
  using RosOut = sensor_msgs::BasicImage<BulkBytes>;
  using Ignition = ignition::msgs::Image;

  static void convert(const Ignition& from, RosOut& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.height = from.height();
    to.width = from.width();
    const auto* format = std::ranges::find(kImageFormats, from.pixel_format_type(), &ImageFormat::type);
    const bool isKnown = format != std::end(kImageFormats);
    to.encoding = isKnown ? format->encoding : std::string_view();
    to.is_bigendian = 0;
    to.step = isKnown ? to.width * format->bytes : from.step();
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_width(from.width);
    to.set_height(from.height);
    to.set_step(from.step);
    const auto* format = std::ranges::find(kImageFormats, from.encoding, &ImageFormat::encoding);
    to.set_pixel_format_type(format != std::end(kImageFormats) ? format->type : ignition::msgs::UNKNOWN_PIXEL_FORMAT);
    to.set_data(from.data.data(), from.data.size());
  }
};

struct PointCloudPair {
  using Ros = sensor_msgs::PointCloud2;
  using RosOut = sensor_msgs::BasicPointCloud2<BulkBytes>;
  using Ignition = ignition::msgs::PointCloudPacked;
  using Field = ignition::msgs::PointCloudPacked::Field;

  static void convert(const Ignition& from, RosOut& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.height = from.height();
    to.width = from.width();
    to.fields.resize(static_cast<std::size_t>(from.field_size()));
    for (int i = 0; i < from.field_size(); ++i) {
      const Field& field = from.field(i);
      // ROS numbers the types from 1 on, in the same order
      to.fields[static_cast<std::size_t>(i)] = {field.name(), field.offset(),
                                                static_cast<std::uint8_t>(static_cast<unsigned>(field.datatype()) + 1),
                                                field.count()};
    }
    to.is_bigendian = from.is_bigendian();
    to.point_step = from.point_step();
    to.row_step = from.row_step();
    to.is_dense = from.is_dense();
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_height(from.height);
    to.set_width(from.width);
    to.clear_field();
    for (const sensor_msgs::PointField& each : from.fields) {
      Field* field = to.add_field();
      field->set_name(each.name);
      field->set_offset(each.offset);
      const int type = each.datatype - 1;
      field->set_datatype(Field::DataType_IsValid(type) ? static_cast<Field::DataType>(type) : Field::INT8);
      field->set_count(each.count);
    }
    to.set_is_bigendian(from.is_bigendian);
    to.set_point_step(from.point_step);
    to.set_row_step(from.row_step);
    to.set_data(from.data.data(), from.data.size());
    to.set_is_dense(from.is_dense);
  }
};

/// Both names of lens models.
struct DistortionName {
  ignition::msgs::CameraInfo::Distortion::DistortionModelType type;
  std::string_view name;
};
constexpr DistortionName kDistortions[] = {
    {ignition::msgs::CameraInfo::Distortion::PLUMB_BOB, "plumb_bob"},
    {ignition::msgs::CameraInfo::Distortion::RATIONAL_POLYNOMIAL, "rational_polynomial"},
    {ignition::msgs::CameraInfo::Distortion::EQUIDISTANT, "equidistant"},
};

struct CameraInfoPair {
  using Ros = sensor_msgs::CameraInfo;
  using Ignition = ignition::msgs::CameraInfo;

  static void convert(const Ignition& from, Ros& to, const Frames& frames) {
    ros2::convert(from.header(), to.header, frames);
    to.height = from.height();
    to.width = from.width();
    const auto* model = std::ranges::find(kDistortions, from.distortion().model(), &DistortionName::type);
    to.distortion_model = from.has_distortion() && model != std::end(kDistortions) ? model->name : std::string_view();
    copyNumbers(from.distortion().k(), to.d);
    copyToArray(from.intrinsics().k(), to.k);
    copyToArray(from.rectification_matrix(), to.r);
    copyToArray(from.projection().p(), to.p);
  }
  static void convert(const Ros& from, Ignition& to, const Frames& frames) {
    to.Clear();
    ros2::convert(from.header, *to.mutable_header(), frames);
    to.set_width(from.width);
    to.set_height(from.height);
    const auto* model = std::ranges::find(kDistortions, from.distortion_model, &DistortionName::name);
    auto* distortion = to.mutable_distortion();
    if (model != std::end(kDistortions)) distortion->set_model(model->type);
    addNumbers(from.d, distortion->mutable_k());
    addNumbers(from.k, to.mutable_intrinsics()->mutable_k());
    addNumbers(from.p, to.mutable_projection()->mutable_p());
    addNumbers(from.r, to.mutable_rectification_matrix());
  }
};

}  // namespace

std::vector<Pair> imagePairs() {
  return {pairOf<ImagePair>(Choice::kDefault), pairOf<PointCloudPair>(Choice::kDefault),
          pairOf<CameraInfoPair>(Choice::kDefault)};
}

}  // namespace pongsim::ros2
