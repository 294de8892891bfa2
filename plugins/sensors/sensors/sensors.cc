#include "camera.hh"
#include "lidar.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

class Sensors final : public System {
 public:
  void declare(Declaration& declaration) override {
    const std::string sensor = "/world/W/model/M/link/L/sensor/S";
    declaration.is("Publishes lidar scans, point clouds and camera images.", Declaration::Place::kWorld);
    declaration.element("render_engine", "selects a renderer in Fortress; no effect in pongsim");
    declaration.element("background_color", "red, green, blue and opacity, replaces the scene's `<background>`");
    declaration.element("ambient_light", "the same for its `<ambient>`");
    declaration.parameter("disable_on_drained_battery", &restsWithoutPower_, "",
                          "switches off sensors of models with empty batteries");
    declaration.publishes(sensor + "/scan", "ignition.msgs.LaserScan",
                          "one per lidar; `<topic>` in the `<sensor>` renames it, `<update_rate>` sets its rate");
    declaration.publishes(sensor + "/scan/points", "ignition.msgs.PointCloudPacked",
                          "point cloud of each lidar: the scan's topic with `/points`");
    declaration.publishes(sensor + "/image", "ignition.msgs.Image",
                          "colour image of each `camera`, and of each `rgbd_camera` with `/image`");
    declaration.publishes(sensor + "/depth_image", "ignition.msgs.Image",
                          "depth image [m] of each `depth_camera`, and of each `rgbd_camera` with `/depth_image`");
    declaration.publishes(sensor + "/depth_image/points", "ignition.msgs.PointCloudPacked",
                          "point cloud of each `depth_camera` and `rgbd_camera`: its topic with `/points`");
    declaration.publishes(sensor + "/camera_info", "ignition.msgs.CameraInfo",
                          "of each camera, beside its images; renamed by `<camera_info_topic>`");
    SensorTopic::declare(declaration);
  }

  void configure(const SystemContext& context) override {
    lidars_.configure(context);
    cameras_.configure(context);
  }
  void worldChanged() override {
    lidars_.worldChanged();
    cameras_.worldChanged();
  }
  void postUpdate(const StepInfo& info) override {
    lidars_.postUpdate(info);
    cameras_.postUpdate(info);
  }
  void reset() override {
    lidars_.reset();
    cameras_.reset();
  }
  void transfer(StateArchive& archive) override {
    lidars_.transfer(archive);
    cameras_.transfer(archive);
  }

 private:
  /// Read again by `Surroundings`.
  bool restsWithoutPower_ = false;
  SensorSystem<LidarSensor> lidars_;
  SensorSystem<CameraSensor> cameras_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Sensors, "ignition::gazebo::systems::Sensors", "gz::sim::systems::Sensors");
