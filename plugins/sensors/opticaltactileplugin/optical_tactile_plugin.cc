#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/pointcloud_packed.pb.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pongsim/geometry/shape.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

namespace im = ignition::msgs;
using Eigen::Vector3f;

/// Reads the points of a camera that lie in a box ahead of it.
class PointsInBox {
 public:
  /// @param behind How far the camera is behind the middle of the sensor [m].
  /// @param margin By how much the box is larger than the sensor [m].
  PointsInBox(double behind, const Vector3& size, double margin)
      : least_(Vector3(behind, -size.y() / 2, -size.z() / 2).array() - margin),
        most_(Vector3(behind + size.x(), size.y() / 2, size.z() / 2).array() + margin) {}

  /// @return Whether the message has what is read.
  static bool canRead(const im::PointCloudPacked& cloud) {
    if (cloud.field_size() < 3) return false;
    for (int i = 0; i < 3; ++i) {
      const auto& field = cloud.field(i);
      if (field.datatype() != im::PointCloudPacked::Field::FLOAT32) return false;
      if (std::uint64_t{field.offset()} + sizeof(float) > cloud.point_step()) return false;
    }
    const std::uint64_t row = std::uint64_t{cloud.width()} * cloud.point_step();
    return row <= cloud.row_step() && std::uint64_t{cloud.row_step()} * cloud.height() <= cloud.data().size();
  }

  /// @return The point; infinite outside the box.
  Vector3f at(const im::PointCloudPacked& cloud, std::uint32_t column, std::uint32_t row) const {
    const char* begin =
        cloud.data().data() + std::size_t{row} * cloud.row_step() + std::size_t{column} * cloud.point_step();
    Vector3f point;
    for (int i = 0; i < 3; ++i) std::memcpy(&point[i], begin + cloud.field(i).offset(), sizeof(float));
    const Vector3 place = point.cast<double>();
    const bool isInside = (place.array() >= least_.array()).all() && (place.array() <= most_.array()).all();
    return isInside ? point : Vector3f::Constant(std::numeric_limits<float>::infinity());
  }

 private:
  Vector3 least_;
  Vector3 most_;
};

/// Publishes the directions of the forces on a soft pad that a depth camera watches from behind.
class OpticalTactilePlugin : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(
        "Publishes the normals of what presses against a pad, which a depth camera sees through it. Its model has one "
        "link, with a box as collision, a contact sensor, and a depth camera with an `<update_rate>`.",
        Declaration::Place::kModel);
    declaration.parameter("enabled", &isEnabled_, "", "whether it measures from the start");
    declaration.parameter("namespace", &namespace_, "", "N in its topic and service");
    declaration.parameter("visualization_resolution", &stride_, "pixels", "one normal for so many pixels each way")
        .atLeast(1);
    declaration.parameter("extended_sensing", &margin_, "m", "how far outside the pad points are still used")
        .atLeast(0);
    declaration.element("visualize_sensor", "has no effect");
    declaration.element("visualize_contacts", "has no effect");
    declaration.element("visualize_forces", "has no effect");
    declaration.element("force_length", "has no effect");
    declaration.publishes("/N/normal_forces", "ignition.msgs.Image",
                          "unit vectors in the camera's frame, three 32-bit floats for each pixel, as many as the "
                          "camera has: at the first, (1, 1), and those a multiple of the resolution away; others are "
                          "zero, and those beside points outside the pad are not numbers");
    declaration.serves("/N/enable", "ignition.msgs.Boolean", "ignition.msgs.Empty", "switches it on or off");
  }

  void configure(const SystemContext& context) override {
    context_ = &context.sdf;
    const std::vector<Link> links = context.model->links();
    if (links.size() != 1) refuse(context.sdf, "its model must have one link");
    const Link& link = links.front();
    const Sensor camera = cameraOf(link);
    // as in Fortress, which knows of no other directions than straight behind
    points_.emplace(std::abs(camera.poseInLink().position.x()), sizeOf(link), margin_);
    forces_ = context.node.advertise<im::Image>("/" + namespace_ + "/normal_forces");
    service_ = context.node.serve<im::Boolean, im::Empty>("/" + namespace_ + "/enable",
                                                          [this](const im::Boolean& request, im::Empty&) {
                                                            isEnabled_ = request.data();
                                                            return true;
                                                          });
    isEnabledAtStart_ = isEnabled_;
    cloud_ = context.node.subscribe<im::PointCloudPacked>(camera.topic("/depth_image") + "/points",
                                                          [this](const auto& cloud) { measure(cloud); });
  }

  void reset() override { isEnabled_ = isEnabledAtStart_; }
  void transfer(StateArchive& archive) override { archive(isEnabled_); }

 private:
  Sensor cameraOf(const Link& link) const {
    std::optional<Sensor> camera;
    int cameras = 0, contacts = 0;
    for (const Sensor& sensor : link.sensors()) {
      if (sensor.type() == "contact") ++contacts;
      if (sensor.type() != "depth_camera" && sensor.type() != "depth") continue;
      ++cameras;
      camera = sensor;
    }
    if (cameras != 1 || contacts != 1) refuse(*context_, "its link must have one depth camera and one contact sensor");
    if (camera->sdf().child("update_rate") == nullptr) refuse(camera->sdf(), "its depth camera has no <update_rate>");
    return *camera;
  }

  Vector3 sizeOf(const Link& link) const {
    for (const Collision& collision : link.collisions()) {
      const Shape shape = collision.shape();
      if (const auto* box = std::get_if<BoxShape>(&shape)) return box->size;
    }
    refuse(*context_, "its link has no box as collision");
  }

  void measure(const im::PointCloudPacked& cloud) {
    if (!isEnabled_ || !forces_.hasSubscribers()) return;
    if (!PointsInBox::canRead(cloud)) return;
    const std::uint32_t width = cloud.width(), height = cloud.height();
    const auto stride = static_cast<std::uint32_t>(stride_);
    normals_.assign(std::size_t{width} * height, Vector3f::Zero());
    for (std::uint32_t row = 1; row + 1 < height; row += stride) {
      for (std::uint32_t column = 1; column + 1 < width; column += stride) {
        normals_[std::size_t{row} * width + column] = normalAt(cloud, column, row);
      }
    }
    im::Image image;
    *image.mutable_header() = cloud.header();
    image.set_width(width);
    image.set_height(height);
    image.set_step(static_cast<std::uint32_t>(sizeof(Vector3f)) * width);
    image.set_pixel_format_type(im::R_FLOAT32);
    image.set_data(normals_.data(), normals_.size() * sizeof(Vector3f));
    forces_.publish(image);
  }

  /// From the differences of neighbouring points.
  Vector3f normalAt(const im::PointCloudPacked& cloud, std::uint32_t column, std::uint32_t row) const {
    const Vector3f right = points_->at(cloud, column + 1, row), left = points_->at(cloud, column - 1, row);
    const Vector3f below = points_->at(cloud, column, row + 1), above = points_->at(cloud, column, row - 1);
    const float across = (right.x() - left.x()) / std::abs(right.y() - left.y());
    const float down = (below.x() - above.x()) / std::abs(below.z() - above.z());
    const Vector3f direction(-1, -across, -down);
    return direction / direction.norm();
  }

  bool isEnabled_ = true;
  bool isEnabledAtStart_ = true;
  std::string namespace_ = "optical_tactile_sensor";
  int stride_ = 30;
  double margin_ = 0.001;

  const Element* context_ = nullptr;
  std::optional<PointsInBox> points_;
  std::vector<Vector3f> normals_;
  Publisher forces_;
  Subscription cloud_;
  Service service_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::OpticalTactilePlugin, "ignition::gazebo::systems::OpticalTactilePlugin",
                      "gz::sim::systems::OpticalTactilePlugin");
