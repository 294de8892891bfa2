#include <ignition/msgs/logical_camera_image.pb.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pongsim/math.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

/// Replaces `all` by the models and their nested models, sorted by their own names, as in Fortress.
void listModels(const World& world, std::vector<Model>& all) {
  all = world.models();
  for (std::size_t i = 0; i < all.size(); ++i) {
    // a copy, because the list grows
    const std::vector<Model> inner = all[i].models();
    all.insert(all.end(), inner.begin(), inner.end());
  }
  std::ranges::stable_sort(all, {}, [](const Model& model) { return model.name(); });
}

class LogicalCameraSensor final : public SensorOf<ignition::msgs::LogicalCameraImage> {
 public:
  static constexpr SensorKind kKind{.text = "Publishes the models in view of logical cameras, with their poses.",
                                    .type = "logical_camera",
                                    .suffix = "/logical_camera"};

  explicit LogicalCameraSensor(const SensorContext& context)
      : SensorOf(context),
        sensor_(context.sensor),
        world_(context.world),
        settings_(*sensor_.settings<LogicalCameraSettings>()) {}

  void measure() override {
    const Pose X_WorldSensor = sensor_.pose();
    const Pose X_SensorWorld = X_WorldSensor.inverse();
    setPose(X_WorldSensor, *message().mutable_pose());
    message().clear_model();
    listModels(world_, models_);
    for (const Model& model : models_) {
      const Pose X_SensorModel = X_SensorWorld * model.pose();
      if (!sees(X_SensorModel.position)) continue;
      ignition::msgs::LogicalCameraImage::Model& seen = *message().add_model();
      seen.set_name(std::string(model.name()));
      setPose(X_SensorModel, *seen.mutable_pose());
    }
  }

 private:
  /// @param point In the sensor's frame, whose x axis points ahead.
  bool sees(const Vector3& point) const {
    const double halfWidth = point.x() * math::tan(settings_.horizontalFov / 2);
    return point.x() >= settings_.near && point.x() <= settings_.far && std::abs(point.y()) <= halfWidth &&
           std::abs(point.z()) <= halfWidth / settings_.aspectRatio;
  }

  Sensor sensor_;
  World world_;
  LogicalCameraSettings settings_;
  std::vector<Model> models_;
};

using LogicalCamera = SensorSystemFor<LogicalCameraSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::LogicalCamera, "ignition::gazebo::systems::LogicalCamera",
                      "gz::sim::systems::LogicalCamera");
