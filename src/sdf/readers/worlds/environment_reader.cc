#include "sdf/readers/worlds/environment_reader.hh"

#include <numbers>
#include <string>

#include "pongsim/handles.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

description::Atmosphere readAtmosphere(const Element& element, Context& context) {
  description::Atmosphere air;
  air.temperature = readPositive(element, "temperature", air.temperature, context);
  air.temperatureGradient = readNumber(element, "temperature_gradient", air.temperatureGradient, context);
  air.pressure = readPositive(element, "pressure", air.pressure, context);
  return air;
}

description::SphericalCoordinates readSphericalCoordinates(const Element& element, Context& context) {
  description::SphericalCoordinates place;
  place.isGiven = true;
  if (const std::string_view model = childText(element, "surface_model"); !model.empty()) place.surfaceModel = model;
  if (const std::string_view axes = childText(element, "world_frame_orientation"); !axes.empty()) {
    place.worldFrameOrientation = axes;
  }
  place.latitude = readNumber(element, "latitude_deg", 0, context) * kDegree;
  place.longitude = readNumber(element, "longitude_deg", 0, context) * kDegree;
  place.elevation = readNumber(element, "elevation", 0, context);
  place.heading = readNumber(element, "heading_deg", 0, context) * kDegree;
  return place;
}

Vector3 readWind(const Element& element, Context& context) {
  const Vector3 wind = readVector(element, "linear_velocity", Vector3::Zero(), context);
  // the square of a finite number can be infinite
  if (wind.stableNorm() <= kFastestWind) return wind;
  context.diagnostics.warning(element.child("linear_velocity")->position,
                              "a wind of '" + element.child("linear_velocity")->text +
                                  "' m/s is ignored: the limit is " + std::to_string(static_cast<int>(kFastestWind)) +
                                  " m/s",
                              "a hurricane reaches 50 m/s");
  return Vector3::Zero();
}

}  // namespace

description::Environment readEnvironment(const Element& world, Context& context) {
  description::Environment environment;
  if (const Element* wind = world.child("wind")) {
    environment.wind = readWind(*wind, context);
  }
  environment.magneticField = readVector(world, "magnetic_field", environment.magneticField, context);
  if (const Element* air = world.child("atmosphere")) environment.atmosphere = readAtmosphere(*air, context);
  if (const Element* place = world.child("spherical_coordinates")) {
    environment.sphericalCoordinates = readSphericalCoordinates(*place, context);
  }
  return environment;
}

}  // namespace pongsim::sdf
