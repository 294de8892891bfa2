#include "dvl_settings.hh"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string_view>

#include "pongsim/math.hh"
#include "pongsim/parameters.hh"

namespace pongsim {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMostBins = 1000;

/// @return The element `gz:NAME` or `ignition:NAME`; null without one.
const Element* extension(const Element& parent, const std::string& name) {
  for (const char* const prefix : {"gz:", "ignition:"}) {
    if (const Element* found = parent.child(prefix + name)) return found;
  }
  return nullptr;
}

const Element& partOf(const Element& parent, const char* name) {
  const Element* found = parent.child(name);
  if (found == nullptr) refuse(parent, "<" + parent.name + "> has no <" + name + ">");
  return *found;
}

double finiteOr(const Element& parent, const char* name, double fallback) {
  const double value = parent.get(name, fallback);
  if (!std::isfinite(value)) refuse(*parent.child(name), std::string("<") + name + "> must be finite");
  return value;
}

double positiveOr(const Element& parent, const char* name, double fallback) {
  const double value = finiteOr(parent, name, fallback);
  if (value <= 0) refuse(*parent.child(name), std::string("<") + name + "> must be above 0");
  return value;
}

DvlBeam readBeam(const Element& element, int defaultId, double unit) {
  DvlBeam beam;
  beam.id = defaultId;
  if (const Element::Attribute* id = element.attribute("id")) {
    beam.id =
        Element{.name = "id", .text = id->value, .attributes = {}, .children = {}, .position = id->position}.as<int>();
  }
  beam.aperture = positiveOr(element, "aperture", kPi / 2 / unit) * unit;
  if (beam.aperture > kPi) refuse(*element.child("aperture"), "<aperture> must be at most half a turn");
  const double tilt = std::remainder(finiteOr(element, "tilt", 0) * unit, 2 * kPi);
  if (std::abs(tilt) >= kPi / 2) refuse(*element.child("tilt"), "<tilt> must be less than a quarter of a turn");
  const double rotation = finiteOr(element, "rotation", 0) * unit;
  // down, tilted towards -x, and rotated about the vertical
  const auto [sinTilt, cosTilt] = math::sinCos(tilt);
  const auto [sinRotation, cosRotation] = math::sinCos(rotation);
  beam.axis = {-cosRotation * sinTilt, sinRotation * sinTilt, -cosTilt};
  return beam;
}

std::vector<DvlBeam> readBeams(const Element& arrangement) {
  const std::string degrees = arrangement.attributeOr("degrees", "false");
  const double unit = degrees == "true" || degrees == "1" ? kPi / 180 : 1;
  std::vector<DvlBeam> beams;
  for (const Element* element : arrangement.childrenNamed("beam")) {
    beams.push_back(readBeam(*element, beams.empty() ? 0 : beams.back().id + 1, unit));
  }
  if (beams.size() < 3) refuse(arrangement, "<arrangement> needs at least three <beam>s");
  return beams;
}

DvlSettings::Mode readMode(const Element& element) {
  DvlSettings::Mode mode;
  const std::string when = element.get<std::string>("when", "always");
  if (when == "always") {
    mode.when = DvlSettings::When::kAlways;
  } else if (when == "best") {
    mode.when = DvlSettings::When::kBest;
  } else if (when != "never") {
    refuse(*element.child("when"), "<when> is '" + when + "'", "it can be always, best or never");
  }
  mode.noise = noiseIn(element);
  return mode;
}

void readWaterMode(const Element& element, DvlSettings& settings) {
  settings.water = readMode(element);
  if (settings.water.when == DvlSettings::When::kNever) return;
  const Element& velocity = partOf(element, "water_velocity");
  settings.waterVelocity = {velocity.get<std::string>("x", ""), velocity.get<std::string>("y", ""),
                            velocity.get<std::string>("z", "")};
  if (std::ranges::all_of(settings.waterVelocity, &std::string::empty)) {
    refuse(velocity, "<water_velocity> names no quantity of the environment", "write <x>, <y> or <z>");
  }
  settings.bins = element.get("bins", settings.bins);
  if (settings.bins < 1 || settings.bins > kMostBins) {
    refuse(*element.child("bins"), "<bins> must be from 1 to " + std::to_string(kMostBins));
  }
  const Element* boundaries = element.child("boundaries");
  if (boundaries == nullptr) return;
  settings.near = finiteOr(*boundaries, "near", settings.near);
  settings.far = finiteOr(*boundaries, "far", settings.far);
  if (settings.near < 0 || settings.near >= settings.far || settings.far > settings.maxRange) {
    refuse(*boundaries, "<boundaries>: <near> must be below <far>, and that within the <maximum_range>");
  }
}

Quaternion rotationIn(const Element& pose) {
  std::istringstream numbers(pose.text);
  std::array<double, 6> values{};
  for (double& value : values) {
    if (!(numbers >> value)) refuse(pose, "<" + pose.name + "> needs six numbers");
  }
  return fromRollPitchYaw(values[3], values[4], values[5]);
}

}  // namespace

DvlSettings readDvl(const Element& sensor) {
  DvlSettings settings;
  const Element* dvl = extension(sensor, "dvl");
  if (dvl == nullptr) refuse(sensor, "a sensor of the type dvl needs a <gz:dvl>");
  const std::string type = dvl->get<std::string>("type", "piston");
  if (type != "piston" && type != "phased_array") {
    refuse(*dvl->child("type"), "<type> is '" + type + "'", "it can be piston or phased_array");
  }
  if (type == "phased_array") settings.type = DvlSettings::Type::kPhasedArray;
  settings.beams = readBeams(partOf(*dvl, "arrangement"));
  settings.resolution = positiveOr(*dvl, "resolution", settings.resolution);
  settings.minRange = positiveOr(*dvl, "minimum_range", settings.minRange);
  settings.maxRange = positiveOr(*dvl, "maximum_range", settings.maxRange);
  settings.near = 0.2 * settings.maxRange;
  settings.far = 0.8 * settings.maxRange;
  const Element& tracking = partOf(*dvl, "tracking");
  if (const Element* mode = tracking.child("bottom_mode")) settings.bottom = readMode(*mode);
  if (const Element* mode = tracking.child("water_mass_mode")) readWaterMode(*mode, settings);
  if (const Element* frame = dvl->child("reference_frame")) settings.toReference = rotationIn(*frame).conjugate();
  return settings;
}

std::vector<Vector3> raysOf(const DvlBeam& beam, double resolution) {
  const Vector3 across = beam.axis.unitOrthogonal(), up = beam.axis.cross(across);
  std::vector<Vector3> rays{beam.axis};
  for (int ring = 1; ring * resolution < beam.aperture / 2; ++ring) {
    const auto [sine, cosine] = math::sinCos(ring * resolution);
    const int count = static_cast<int>(std::ceil(2 * kPi * sine / resolution));
    for (int i = 0; i < count; ++i) {
      const auto [sinTurn, cosTurn] = math::sinCos(2 * kPi * i / count);
      rays.push_back(cosine * beam.axis + sine * (cosTurn * across + sinTurn * up));
    }
  }
  return rays;
}

}  // namespace pongsim
