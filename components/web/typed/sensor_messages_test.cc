#include "web/typed/sensor_messages.hh"

#include <foxglove/sensors.pb.h>
#include <google/protobuf/descriptor.h>
#include <gtest/gtest.h>
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/laserscan.pb.h>
#include <ignition/msgs/navsat.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

namespace pongsim::web::typed {
namespace {

namespace im = ignition::msgs;

/// @return The converted message, or nothing.
template <class Out>
std::optional<Out> become(const google::protobuf::Message& in) {
  const auto conversion = conversionOf(in.GetTypeName());
  if (!conversion) return std::nullopt;
  EXPECT_EQ(conversion->type.full_name(), Out::descriptor()->full_name());
  const std::string bytes = in.SerializeAsString();
  const auto converted = conversion->convert(std::as_bytes(std::span(bytes)), 7'000'000'000);
  Out out;
  if (!converted || !out.ParseFromString(*converted)) return std::nullopt;
  return out;
}

void setFrame(const std::string& frame, im::Header& header) {
  auto& entry = *header.add_data();
  entry.set_key("frame_id");
  entry.add_value(frame);
}

TEST(SensorMessages, ConvertImages) {
  im::Image image;
  setFrame("eye", *image.mutable_header());
  image.mutable_header()->mutable_stamp()->set_sec(3);
  image.set_width(2);
  image.set_height(1);
  image.set_step(6);
  image.set_pixel_format_type(im::RGB_INT8);
  image.set_data("abcdef");
  const auto raw = become<::foxglove::RawImage>(image);
  ASSERT_TRUE(raw.has_value());
  EXPECT_EQ(raw->frame_id(), "eye");
  EXPECT_EQ(raw->timestamp().seconds(), 3);
  EXPECT_EQ(raw->width(), 2U);
  EXPECT_EQ(raw->step(), 6U);
  EXPECT_EQ(raw->encoding(), "rgb8");
  EXPECT_EQ(raw->data(), "abcdef");
  image.set_pixel_format_type(im::RGB_INT32);
  EXPECT_FALSE(become<::foxglove::RawImage>(image).has_value());
}

TEST(SensorMessages, KnowTheFormatsOfPixels) {
  const std::pair<im::PixelFormatType, const char*> kFormats[] = {
      {im::RGBA_INT8, "rgba8"},         {im::BGR_INT8, "bgr8"},
      {im::BGRA_INT8, "bgra8"},         {im::L_INT8, "mono8"},
      {im::L_INT16, "mono16"},          {im::R_FLOAT32, "32FC1"},
      {im::BAYER_RGGB8, "bayer_rggb8"}, {im::BAYER_GBRG8, "bayer_gbrg8"},
      {im::BAYER_GRBG8, "bayer_grbg8"}};
  for (const auto& [format, name] : kFormats) {
    im::Image image;
    image.set_width(1);
    image.set_height(1);
    image.set_step(4);
    image.set_pixel_format_type(format);
    image.set_data("abcd");
    const auto raw = become<::foxglove::RawImage>(image);
    ASSERT_TRUE(raw.has_value()) << name;
    EXPECT_EQ(raw->encoding(), name);
  }
}

TEST(SensorMessages, KnowTheTypesOfPointsAndTheModelsOfLenses) {
  using Field = im::PointCloudPacked::Field;
  using Packed = ::foxglove::PackedElementField;
  const std::pair<Field::DataType, Packed::NumericType> kTypes[] = {
      {Field::INT8, Packed::INT8},       {Field::UINT8, Packed::UINT8},    {Field::INT16, Packed::INT16},
      {Field::UINT16, Packed::UINT16},   {Field::INT32, Packed::INT32},    {Field::UINT32, Packed::UINT32},
      {Field::FLOAT32, Packed::FLOAT32}, {Field::FLOAT64, Packed::FLOAT64}};
  im::PointCloudPacked cloud;
  cloud.set_point_step(16);
  for (const auto& [type, packed] : kTypes) cloud.add_field()->set_datatype(type);
  const auto out = become<::foxglove::PointCloud>(cloud);
  ASSERT_TRUE(out.has_value());
  for (int i = 0; i < out->fields_size(); ++i) EXPECT_EQ(out->fields(i).type(), kTypes[i].second);

  im::CameraInfo info;
  info.mutable_distortion()->set_model(im::CameraInfo::Distortion::RATIONAL_POLYNOMIAL);
  EXPECT_EQ(become<::foxglove::CameraCalibration>(info)->distortion_model(), "rational_polynomial");
  info.mutable_distortion()->set_model(im::CameraInfo::Distortion::EQUIDISTANT);
  EXPECT_EQ(become<::foxglove::CameraCalibration>(info)->distortion_model(), "kannala_brandt");
}

TEST(SensorMessages, ConvertTheMiddleRowOfScans) {
  im::LaserScan scan;
  scan.set_frame("beam");
  scan.set_angle_min(-1);
  scan.set_angle_max(1);
  scan.set_count(2);
  scan.set_vertical_count(3);
  for (int i = 0; i < 6; ++i) {
    scan.add_ranges(i);
    scan.add_intensities(10 + i);
  }
  const auto flat = become<::foxglove::LaserScan>(scan);
  ASSERT_TRUE(flat.has_value());
  EXPECT_EQ(flat->frame_id(), "beam");
  EXPECT_EQ(flat->timestamp().seconds(), 7);
  EXPECT_EQ(flat->start_angle(), -1);
  EXPECT_EQ(std::vector<double>(flat->ranges().begin(), flat->ranges().end()), (std::vector<double>{2, 3}));
  EXPECT_EQ(flat->intensities(1), 13);
  EXPECT_EQ(flat->pose().orientation().w(), 1);
  scan.set_count(7);
  EXPECT_FALSE(become<::foxglove::LaserScan>(scan).has_value());
  scan.set_count(4'000'000'000);
  EXPECT_FALSE(become<::foxglove::LaserScan>(scan).has_value());
}

TEST(SensorMessages, ConvertClouds) {
  im::PointCloudPacked cloud;
  cloud.set_point_step(16);
  cloud.set_data("0123456789abcdef");
  auto& field = *cloud.add_field();
  field.set_name("x");
  field.set_offset(4);
  field.set_datatype(im::PointCloudPacked::Field::FLOAT32);
  const auto out = become<::foxglove::PointCloud>(cloud);
  ASSERT_TRUE(out.has_value());
  EXPECT_EQ(out->point_stride(), 16U);
  EXPECT_EQ(out->fields(0).name(), "x");
  EXPECT_EQ(out->fields(0).offset(), 4U);
  EXPECT_EQ(out->fields(0).type(), ::foxglove::PackedElementField::FLOAT32);
  EXPECT_EQ(out->data(), cloud.data());
  cloud.set_point_step(0);
  EXPECT_FALSE(become<::foxglove::PointCloud>(cloud).has_value());
}

TEST(SensorMessages, ConvertWhatIsKnownOfCamerasAndPlaces) {
  im::CameraInfo info;
  info.set_width(640);
  info.mutable_intrinsics()->add_k(500);
  info.mutable_projection()->add_p(501);
  info.mutable_distortion()->add_k(0.1);
  info.add_rectification_matrix(1);
  const auto camera = become<::foxglove::CameraCalibration>(info);
  ASSERT_TRUE(camera.has_value());
  EXPECT_EQ(camera->width(), 640U);
  EXPECT_EQ(camera->distortion_model(), "plumb_bob");
  EXPECT_EQ(camera->k(0), 500);
  EXPECT_EQ(camera->p(0), 501);
  EXPECT_EQ(camera->d(0), 0.1);
  EXPECT_EQ(camera->r(0), 1);
  im::NavSat place;
  place.set_latitude_deg(47);
  place.set_frame_id("m::l::s");
  const auto fix = become<::foxglove::LocationFix>(place);
  ASSERT_TRUE(fix.has_value());
  EXPECT_EQ(fix->latitude(), 47);
  EXPECT_EQ(fix->frame_id(), "m::l::s");
}

TEST(SensorMessages, LeaveOthersAlone) {
  EXPECT_FALSE(conversionOf("ignition.msgs.Twist").has_value());
  EXPECT_FALSE(conversionOf("ignition.msgs.Image")->convert(std::as_bytes(std::span("\xff", 1)), 0).has_value());
}

}  // namespace
}  // namespace pongsim::web::typed
