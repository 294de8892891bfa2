#include "sdf/readers/shapes/polyline_reader.hh"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "sdf/readers/shapes/extrusion.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

/// @return The points, without those equal to the one before.
std::vector<Eigen::Vector2d> readLine(const Element& polyline, Context& context) {
  std::vector<Eigen::Vector2d> line;
  for (const Element* element : polyline.childrenNamed("point")) {
    const auto values = readNumbers(*element, 2, "two finite numbers", context);
    if (!values) continue;
    const Eigen::Vector2d point((*values)[0], (*values)[1]);
    if (line.empty() || line.back() != point) line.push_back(point);
  }
  while (line.size() > 1 && line.front() == line.back()) line.pop_back();
  return line;
}

}  // namespace

description::Polyline readPolylines(const Element& geometry, const std::string& owner, bool isCollision,
                                    Context& context) {
  description::Polyline polyline;
  std::size_t count = 0;
  std::optional<double> height;
  const Element& first = *geometry.child("polyline");
  const auto warn = [&](const Element& element, std::string message) {
    context.diagnostics.warning(element.position, std::move(message));
  };
  for (const Element* element : geometry.childrenNamed("polyline")) {
    const double ownHeight = readPositive(*element, "height", polyline.height, context);
    if (height && *height != ownHeight) {
      warn(*element, "a polyline of " + owner + " has another height than the first: the first is used");
    }
    if (!height) height = polyline.height = ownHeight;
    std::vector<Eigen::Vector2d> line = readLine(*element, context);
    if (line.size() < 3) {
      warn(*element, "a polyline of " + owner + " has fewer than three different points");
      continue;
    }
    count += line.size();
    polyline.lines.push_back(std::move(line));
  }
  const std::string effect = isCollision ? ": it will not collide" : ": it will not be seen";
  if (count > kMostOutlinePoints) {
    warn(first,
         "the polylines of " + owner + " have more than " + std::to_string(kMostOutlinePoints) + " points" + effect);
  } else if (crosses(polyline.lines)) {
    warn(first, "the polylines of " + owner + " cross or touch" + effect);
  } else if (!polyline.lines.empty()) {
    polyline.triangles = extrude(polyline.lines, polyline.height);
  }
  return polyline;
}

}  // namespace pongsim::sdf
