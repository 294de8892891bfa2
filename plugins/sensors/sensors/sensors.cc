#include "camera.hh"
#include "lidar.hh"
#include "pongsim/sensor_system.hh"

namespace pongsim {

namespace {

class Sensors final : public System {
 public:
  void declare(Declaration& declaration) override {
    const std::string sensor = "/world/W/model/M/link/L/sensor/S";
    declaration.is("Publishes what the world's lidars and cameras see.", Declaration::Place::kWorld);
    declaration.element("render_engine", "chooses a renderer in Fortress; here there is none to choose");
    declaration.element("background_color",
                        "red, green, blue and opacity, in place of the `<background>` of the scene");
    declaration.element("ambient_light", "likewise, in place of its `<ambient>`");
    declaration.parameter("disable_on_drained_battery", &restsWithoutPower_, "",
                          "sensors of models whose batteries are all empty rest");
    declaration.publishes(sensor + "/scan", "ignition.msgs.LaserScan",
                          "of each lidar; `<topic>` in the `<sensor>` names another, `<update_rate>` says how often");
    declaration.publishes(sensor + "/scan/points", "ignition.msgs.PointCloudPacked",
                          "of each lidar, the same as points: `/points` behind the scan's topic");
    declaration.publishes(sensor + "/image", "ignition.msgs.Image",
                          "of each `camera`, and with `/image` behind the topic of each `rgbd_camera`: colours");
    declaration.publishes(sensor + "/depth_image", "ignition.msgs.Image",
                          "of each `depth_camera`, and with `/depth_image` behind that of each `rgbd_camera`: metres");
    declaration.publishes(sensor + "/depth_image/points", "ignition.msgs.PointCloudPacked",
                          "`/points` behind the topic of each `depth_camera` and `rgbd_camera`");
    declaration.publishes(sensor + "/camera_info", "ignition.msgs.CameraInfo",
                          "of each camera, beside its images; `<camera_info_topic>` names another");
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
  /// Read again by what the sensors share.
  bool restsWithoutPower_ = false;
  SensorSystem<LidarSensor> lidars_;
  SensorSystem<CameraSensor> cameras_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Sensors, "ignition::gazebo::systems::Sensors", "gz::sim::systems::Sensors");
