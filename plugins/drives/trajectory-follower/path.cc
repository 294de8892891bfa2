#include "path.hh"

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>

#include "pongsim/math.hh"
#include "pongsim/parameters.hh"

namespace pongsim {

namespace {

constexpr int kPointsOfCircle = 8;

double finiteIn(const Element& element, std::string_view name) {
  requiredText(element, name);
  const double value = element.child(name)->as<double>();
  if (!std::isfinite(value)) refuse(*element.child(name), "<" + std::string(name) + "> must be a finite number");
  return value;
}

Vector3 readWaypoint(const Element& element, Diagnostics& diagnostics) {
  std::istringstream stream(element.text);
  std::vector<double> values;
  Element word = element;
  while (stream >> word.text) values.push_back(word.as<double>());
  if (values.size() < 2 || !std::isfinite(values[0]) || !std::isfinite(values[1])) {
    refuse(element, "<waypoint> is '" + element.text + "', which is not two finite numbers");
  }
  if (values.size() > 2) {
    diagnostics.warning(element.position,
                        "of <waypoint> '" + element.text + "' the first two numbers are used, x and y");
  }
  return {values[0], values[1], 0};
}

}  // namespace

Path Path::read(const Element& plugin, Diagnostics& diagnostics) {
  const Element* used = nullptr;
  for (const char* name : {"waypoints", "circle", "line"}) {
    const Element* element = plugin.child(name);
    if (element == nullptr) continue;
    if (used != nullptr) {
      diagnostics.warning(element->position,
                          "<" + element->name + "> has no effect: the path is that of <" + used->name + ">");
    } else {
      used = element;
    }
  }
  if (used == nullptr) {
    refuse(plugin, "no path is given", "add <waypoints>, <circle> or <line>");
  }

  Path path;
  if (used->name == "waypoints") {
    for (const Element* element : used->childrenNamed("waypoint")) {
      path.waypoints_.push_back(readWaypoint(*element, diagnostics));
    }
    if (path.waypoints_.empty()) refuse(*used, "<waypoints> has no <waypoint>", "write <waypoint>x y</waypoint>");
  } else if (used->name == "circle") {
    path.kind_ = Kind::kCircle;
    path.length_ = finiteIn(*used, "radius");
  } else {
    path.kind_ = Kind::kLine;
    path.direction_ = finiteIn(*used, "direction");
    path.length_ = finiteIn(*used, "length");
  }
  return path;
}

std::vector<Vector3> Path::points(const Pose& X_WorldStart) const {
  const Vector3 start(X_WorldStart.position.x(), X_WorldStart.position.y(), 0);
  std::vector<Vector3> points = waypoints_;
  if (kind_ == Kind::kCircle) {
    for (int i = 0; i < kPointsOfCircle; ++i) {
      const double angle = 2 * std::numbers::pi * i / kPointsOfCircle;
      points.push_back(start + length_ * Vector3(math::cos(angle), math::sin(angle), 0));
    }
  } else if (kind_ == Kind::kLine) {
    const Vector3 way = length_ * Vector3(math::cos(direction_), math::sin(direction_), 0);
    Vector3 end = start + X_WorldStart.rotation * way;
    end.z() = 0;
    points = {start, end};
  }
  return points;
}

}  // namespace pongsim
