#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "camera.hh"
#include "cameras/box_camera.hh"
#include "cameras/segmentation_camera.hh"
#include "cameras/thermal_camera.hh"
#include "lidar.hh"
#include "pongsim/sensing/marker_services.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

constexpr const char* kScan = "ignition.msgs.LaserScan";
constexpr const char* kPoints = "ignition.msgs.PointCloudPacked";
constexpr const char* kImage = "ignition.msgs.Image";
constexpr const char* kImageBoxes = "ignition.msgs.AnnotatedAxisAligned2DBox_V";
constexpr const char* kSpaceBoxes = "ignition.msgs.AnnotatedOriented3DBox_V";

/// What lidars and cameras publish.
std::vector<SensorReadings> allReadings() {
  using Readings = SensorReadings;
  std::vector<Readings> all;
  for (const char* type : {"gpu_lidar", "lidar", "gpu_ray", "ray"}) {
    all.push_back({type, Readings::kRanges, LidarSensor::kSuffix, "", kScan});
    all.push_back({type, Readings::kPoints, LidarSensor::kSuffix, "/points", kPoints});
  }
  for (const char* type : {"camera", "thermal", "thermal_camera", "wide_angle_camera", "wideanglecamera"}) {
    all.push_back({type, Readings::kImage, "/image", "", kImage});
  }
  for (const char* type : {"depth_camera", "depth"}) {
    all.push_back({type, Readings::kDepth, "/depth_image", "", kImage});
    all.push_back({type, Readings::kPoints, "/depth_image", "/points", kPoints});
  }
  for (const char* type : {"rgbd_camera", "rgbd"}) {
    all.push_back({type, Readings::kImage, "", "/image", kImage});
    all.push_back({type, Readings::kDepth, "", "/depth_image", kImage});
    all.push_back({type, Readings::kPoints, "", "/points", kPoints});
  }
  for (const char* type : {"segmentation", "segmentation_camera"}) {
    all.push_back({type, Readings::kImage, "/segmentation", "/colored_map", kImage});
    all.push_back({type, SegmentationCamera::kLabels, "/segmentation", "/labels_map", kImage});
  }
  for (const char* type : {"boundingbox", "boundingbox_camera", "boundingbox_camera_3d"}) {
    const bool isInSpace = std::string_view(type).ends_with("3d");
    all.push_back({type, Readings::kMessage, "/boundingbox", "", isInSpace ? kSpaceBoxes : kImageBoxes});
    all.push_back({type, Readings::kImage, "/boundingbox", "_image", kImage});
  }
  return all;
}

/// @return Red, green, blue and optionally opacity of an element; nothing if it is missing.
std::optional<Vector3> colorIn(const Element& plugin, const char* name) {
  const Element* element = plugin.child(name);
  if (element == nullptr) return std::nullopt;
  std::istringstream numbers(element->text);
  Vector3 color;
  if (numbers >> color.x() >> color.y() >> color.z() && color.minCoeff() >= 0) return color;
  throw Error({Severity::kError, element->position,
               "<" + element->name + "> is '" + element->text + "', which is not a colour", "as in 0.7 0.7 0.7 1"});
}

class Sensors final : public SensorSystem {
 public:
  Sensors() : SensorSystem(allReadings()) {}

  void declare(Declaration& declaration) override {
    const std::string sensor = "/world/W/model/M/link/L/sensor/S";
    declaration.is("Publishes lidar scans, point clouds and camera images.", Declaration::Place::kWorld);
    declaration.element("render_engine", "selects a renderer in Fortress; no effect in pongsim");
    declaration.element("background_color", "red, green, blue and opacity, replaces the scene's `<background>`");
    declaration.element("ambient_light", "the same for its `<ambient>`");
    declaration.parameter("disable_on_drained_battery", &restsWithoutPower_, "",
                          "switches off sensors of models with empty batteries");
    declaration.publishes(sensor + "/scan", kScan,
                          "one per lidar; `<topic>` in the `<sensor>` renames it, `<update_rate>` sets its rate");
    declaration.publishes(sensor + "/scan/points", kPoints,
                          "point cloud of each lidar: the scan's topic with `/points`");
    declaration.publishes(sensor + "/image", kImage,
                          "colour image of each `camera`, and of each `rgbd_camera` with `/image`");
    declaration.publishes(sensor + "/depth_image", kImage,
                          "depth image [m] of each `depth_camera`, and of each `rgbd_camera` with `/depth_image`");
    declaration.publishes(sensor + "/depth_image/points", kPoints,
                          "point cloud of each `depth_camera` and `rgbd_camera`: its topic with `/points`");
    declaration.publishes(sensor + "/image", kImage,
                          "temperatures of each `thermal_camera` (`thermal`), divided by its resolution");
    declaration.publishes(sensor + "/image", kImage, "colour image of each `wide_angle_camera` (`wideanglecamera`)");
    declaration.publishes(sensor + "/segmentation/colored_map", kImage,
                          "a colour for each label or instance, of each `segmentation_camera` (`segmentation`)");
    declaration.publishes(sensor + "/segmentation/labels_map", kImage, "its labels and the counts of instances");
    declaration.publishes(sensor + "/boundingbox", kImageBoxes,
                          "boxes in the image of each `boundingbox_camera` (`boundingbox`)");
    declaration.publishes(sensor + "/boundingbox", kSpaceBoxes, "boxes in space, if its `<box_type>` is 3d");
    declaration.publishes(sensor + "/boundingbox_image", kImage, "its image with the boxes drawn");
    declaration.publishes(sensor + "/camera_info", "ignition.msgs.CameraInfo",
                          "of each camera, beside its images; renamed by `<camera_info_topic>`");
    MarkerServices::declare(declaration, MarkerViewers::kSensors);
    SensorSystem::declare(declaration);
  }

  void configure(const SystemContext& context) override {
    plugin_ = &context.sdf;
    logger_ = &context.log;
    SensorSystem::configure(context);
  }

  void postUpdate(const StepInfo& info) override {
    if (lidars_) lidars_->beginStep();
    if (cameras_) cameras_->beginStep();
    if (markers_) markers_->update(info.time);
    SensorSystem::postUpdate(info);
  }

  void reset() override {
    // before the first step, which may have the time of the last one
    if (markers_) markers_->update(Time(0));
    SensorSystem::reset();
  }

 protected:
  void rebuild(Diagnostics& diagnostics) override {
    if (lidars_) lidars_->rebuild(diagnostics);
    if (cameras_) cameras_->rebuild(diagnostics);
  }

  std::unique_ptr<SensorDevice> make(const SensorContext& context) override {
    if (context.sensor.settings<LidarSettings>() != nullptr) {
      return std::make_unique<LidarSensor>(context, lidars(context));
    }
    const std::string_view type = context.sensor.type();
    if (type.starts_with("thermal")) return std::make_unique<ThermalCamera>(context, cameras(context));
    if (type.starts_with("segmentation")) return std::make_unique<SegmentationCamera>(context, cameras(context));
    if (type.ends_with("3d")) return std::make_unique<SpaceBoxCamera>(context, cameras(context));
    if (type.starts_with("boundingbox")) return std::make_unique<ImageBoxCamera>(context, cameras(context));
    return std::make_unique<CameraSensor>(context, cameras(context));
  }

 private:
  // made with the first sensor of the kind, because the libraries that they need are loaded then

  LidarSurroundings& lidars(const SensorContext& context) {
    if (!lidars_) {
      lidars_ = std::make_unique<LidarSurroundings>(context.world, restsWithoutPower_);
      lidars_->rebuild(context.diagnostics);
    }
    return *lidars_;
  }

  CameraSurroundings& cameras(const SensorContext& context) {
    if (!cameras_) {
      auto made = std::make_unique<CameraSurroundings>(context.world, restsWithoutPower_);
      made->scene().setColors(colorIn(*plugin_, "background_color"), colorIn(*plugin_, "ambient_light"));
      cameras_ = std::move(made);
      offerMarkers(context);
      cameras_->rebuild(context.diagnostics);
    }
    return *cameras_;
  }

  void offerMarkers(const SensorContext& context) {
    try {
      markers_.emplace(context.world, context.node, *logger_, MarkerViewers::kSensors);
    } catch (const std::invalid_argument& error) {
      // another system of this kind offers them
      logger_->warning(std::string(error.what()) + ": this system offers none for markers");
    }
  }

  bool restsWithoutPower_ = false;
  const Element* plugin_ = nullptr;
  const Logger* logger_ = nullptr;
  std::unique_ptr<LidarSurroundings> lidars_;
  std::unique_ptr<CameraSurroundings> cameras_;
  std::optional<MarkerServices> markers_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Sensors, "ignition::gazebo::systems::Sensors", "gz::sim::systems::Sensors");
