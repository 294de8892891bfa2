#include "lidar.hh"
#include "pongsim/sensor_system.hh"

namespace pongsim {

namespace {

class Sensors final : public SensorSystem<LidarSensor> {
 public:
  void declare(Declaration& declaration) override {
    SensorSystem::declare(declaration);
    declaration.element("render_engine", "chooses a renderer in Fortress; here there is none to choose");
    declaration.publishes("/world/W/model/M/link/L/sensor/S/scan/points", "ignition.msgs.PointCloudPacked",
                          "of each lidar, the same as points: `/points` behind the scan's topic");
  }
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::Sensors, "ignition::gazebo::systems::Sensors", "gz::sim::systems::Sensors");
