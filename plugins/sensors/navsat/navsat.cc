#include <ignition/msgs/navsat.pb.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "pongsim/geometry/geodesy.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/sensor_system.hh"

namespace pongsim {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// @return The sensor's world, which must have spherical coordinates.
World worldOf(const Sensor& sensor, const World& world) {
  if (!world.tangentPlane()) {
    refuse(sensor.sdf(), "sensor '" + sensor.scopedName() + "' can't measure its position",
           "the world needs <spherical_coordinates>");
  }
  return world;
}

/// @return The angle [degrees], above -180 and up to 180.
double wrapped(double degrees) { return std::remainder(degrees, 360.0); }

class NavSatSensor final : public SensorOf<ignition::msgs::NavSat> {
 public:
  static constexpr SensorKind kKind{
      .text = "Publishes the readings of satellite navigation (GNSS) sensors.", .type = "navsat", .suffix = "/navsat"};

  explicit NavSatSensor(const SensorContext& context)
      : SensorOf(context),
        sensor_(context.sensor),
        world_(worldOf(sensor_, context.world)),
        latitudeNoise_(context.noises.add(settings().horizontalPosition, "latitude")),
        longitudeNoise_(context.noises.add(settings().horizontalPosition, "longitude")),
        altitudeNoise_(context.noises.add(settings().verticalPosition, "altitude")),
        eastNoise_(context.noises.add(settings().horizontalVelocity, "east")),
        northNoise_(context.noises.add(settings().horizontalVelocity, "north")),
        upNoise_(context.noises.add(settings().verticalVelocity, "up")) {
    message().set_frame_id(sensor_.frameName());
  }

  void measure() override {
    // requests may have changed them
    const GeodeticPosition place = world_.tangentPlane()->at(sensor_.pose().position);
    message().set_latitude_deg(wrapped(latitudeNoise_.apply(place.latitude / kDegree)));
    message().set_longitude_deg(wrapped(longitudeNoise_.apply(place.longitude / kDegree)));
    message().set_altitude(altitudeNoise_.apply(place.altitude));
    // Fortress treats x, y and z of the world as east, north and up, whatever its heading
    const Vector3 velocity = sensor_.linearVelocity();
    message().set_velocity_east(eastNoise_.apply(velocity.x()));
    message().set_velocity_north(northNoise_.apply(velocity.y()));
    message().set_velocity_up(upNoise_.apply(velocity.z()));
  }

 private:
  const NavSatSettings& settings() const { return *sensor_.settings<NavSatSettings>(); }

  Sensor sensor_;
  World world_;
  Noise &latitudeNoise_, &longitudeNoise_, &altitudeNoise_;
  Noise &eastNoise_, &northNoise_, &upNoise_;
};

using NavSat = SensorSystemFor<NavSatSensor>;

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::NavSat, "ignition::gazebo::systems::NavSat", "gz::sim::systems::NavSat");
