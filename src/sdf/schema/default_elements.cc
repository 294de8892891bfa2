#include "sdf/schema/default_elements.hh"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/element_edit.hh"
#include "sdf/schema/schema.hh"

namespace pongsim::sdf {

namespace {

/// Required elements, in the format's order where that is not alphabetical.
constexpr auto kOrder = std::to_array<std::string_view>(
    {"world.gravity", "world.magnetic_field", "world.atmosphere", "world.physics", "world.scene",
     // physics
     "physics.ode.solver", "physics.ode.constraints", "physics.ode.solver.type", "physics.ode.solver.iters",
     "physics.ode.solver.sor", "physics.ode.solver.use_dynamic_moi_rescaling", "physics.ode.constraints.cfm",
     "physics.ode.constraints.erp", "physics.ode.constraints.contact_max_correcting_vel",
     "physics.ode.constraints.contact_surface_layer", "physics.bullet.solver", "physics.bullet.constraints",
     "physics.bullet.solver.type", "physics.bullet.solver.iters", "physics.bullet.solver.sor",
     "physics.bullet.constraints.cfm", "physics.bullet.constraints.erp",
     "physics.bullet.constraints.contact_surface_layer", "physics.bullet.constraints.split_impulse",
     "physics.bullet.constraints.split_impulse_penetration_threshold",
     // other parts of a world
     "spherical_coordinates.surface_model", "spherical_coordinates.latitude_deg", "spherical_coordinates.longitude_deg",
     "spherical_coordinates.elevation", "spherical_coordinates.heading_deg", "population.model_count",
     "population.distribution", "road.width", "road.point", "light.spot.inner_angle", "light.spot.outer_angle",
     "light.spot.falloff",
     // models and actors
     "joint.parent", "joint.child", "joint.axis.xyz", "joint.axis.limit", "joint.axis2.xyz", "joint.axis2.limit",
     "actor.script.trajectory.waypoint.time", "actor.script.trajectory.waypoint.pose",
     // shapes
     "capsule.radius", "capsule.length", "cone.radius", "cone.length", "cylinder.radius", "cylinder.length",
     "heightmap.blend.min_height", "heightmap.blend.fade_dist", "heightmap.texture.size", "heightmap.texture.diffuse",
     "heightmap.texture.normal", "image.uri", "image.scale", "image.threshold", "image.height", "image.granularity",
     "polyline.point", "polyline.height", "material.script.uri", "material.script.name",
     "surface.soft_contact.dart.bone_attachment", "surface.soft_contact.dart.stiffness",
     "surface.soft_contact.dart.damping", "surface.soft_contact.dart.flesh_mass_fraction",
     // sensors
     "camera.horizontal_fov", "camera.image", "camera.clip", "camera.clip.near", "camera.clip.far",
     "camera.image.width", "camera.image.height", "camera.lens.type", "camera.lens.scale_to_hfov",
     "camera.lens.intrinsics.fx", "camera.lens.intrinsics.fy", "camera.lens.intrinsics.cx", "camera.lens.intrinsics.cy",
     "camera.lens.intrinsics.s", "lidar.scan", "lidar.range", "lidar.range.min", "lidar.range.max",
     "lidar.scan.horizontal.samples", "lidar.scan.horizontal.resolution", "lidar.scan.horizontal.min_angle",
     "lidar.scan.horizontal.max_angle", "lidar.scan.vertical.samples", "lidar.scan.vertical.min_angle",
     "lidar.scan.vertical.max_angle", "ray.scan", "ray.range", "ray.range.min", "ray.range.max",
     "ray.scan.horizontal.samples", "ray.scan.horizontal.resolution", "ray.scan.horizontal.min_angle",
     "ray.scan.horizontal.max_angle", "ray.scan.vertical.samples", "ray.scan.vertical.min_angle",
     "ray.scan.vertical.max_angle", "logical_camera.near", "logical_camera.far", "logical_camera.aspect_ratio",
     "logical_camera.horizontal_fov", "sonar.min", "sonar.max"});

std::size_t rankOf(const Schema::Part* part) {
  return static_cast<std::size_t>(std::ranges::find(kOrder, part->row.path) - kOrder.begin());
}

bool isIn(int version, const Schema::Part& part) {
  // not in the format, although Fortress reads them
  const bool isOutsideFormat = part.row.path == "sensor.ignition_frame_id" || part.row.path == "sensor.gz_frame_id";
  return part.row.isIn(version) && !isOutsideFormat;
}

/// @return How often the part occurs in its parent, by Fortress's rules: if a part has a file of its own in the
/// format's description, that file counts and not the one that includes it.
char presenceOf(const Schema::Part& part, int version) {
  const Schema& schema = Schema::instance();
  const char presence = part.row.presence.in(version);
  if (part.type == nullptr) return presence;
  if (part.type == schema.typeOf("noise")) return '1';
  const bool isAnyNumber = part.type == schema.typeOf("model") || part.type == schema.typeOf("link");
  return isAnyNumber ? '*' : presence;
}

/// Completes elements of SDF 1.`version`.
class Completion {
 public:
  explicit Completion(int version) : version_(version) {}

  void complete(Element& element, const Schema::Part& part) const {
    static const Schema::ElementType kNothing;
    const Schema::ElementType& type = part.type != nullptr ? *part.type : kNothing;
    dropUnknownAttributes(element, type);
    if (part.isFreeForm) return;
    if (part.row.type.empty()) element.text.clear();
    if (!part.row.type.empty() && element.text.empty()) element.text = defaultText(part.row);

    std::ranges::stable_partition(
        element.children, [this, &type](const Element& child) { return find(type.children, child.name) != nullptr; });
    for (Element& child : element.children) {
      if (const Schema::Part* known = find(type.children, child.name)) complete(child, *known);
    }
    for (const Schema::Part* required : requiredChildren(type, "1+")) {
      if (element.child(required->name) != nullptr) continue;
      element.children.push_back(defaultElement(*required, element.position));
    }
  }

 private:
  /// @return The part with this name in this version, or null.
  const Schema::Part* find(std::span<const Schema::Part> parts, std::string_view name) const {
    const Schema::Part* part = Schema::find(parts, name);
    return part != nullptr && isIn(version_, *part) ? part : nullptr;
  }

  /// @return The value of a required element that the file does not give.
  std::string defaultText(const SchemaRow& row) const {
    const std::string_view fallback = row.fallback.in(version_);
    const bool isNone = row.type == "string" && fallback.empty() && row.path != "frame@name";
    return std::string(isNone && row.presence.in(version_) != '0' ? kNoText : fallback);
  }

  /// @param presences Values of `SchemaRow::presence`: "1", "1+".
  /// @return The children with one of these presences, in the format's order.
  std::vector<const Schema::Part*> requiredChildren(const Schema::ElementType& type, std::string_view presences) const {
    std::vector<const Schema::Part*> parts;
    for (const Schema::Part& part : type.children) {
      const bool isRequired = presences.find(presenceOf(part, version_)) != presences.npos;
      if (isRequired && isIn(version_, part)) parts.push_back(&part);
    }
    std::ranges::stable_sort(parts, {}, rankOf);
    return parts;
  }

  Element defaultElement(const Schema::Part& part, const SourcePosition& position) const {
    Element element = base::makeElement(part.name, position);
    if (!part.row.type.empty()) element.text = defaultText(part.row);
    if (part.type == nullptr) return element;
    for (const Schema::Part& attribute : part.type->attributes) {
      if (!isIn(version_, attribute) || attribute.row.presence.in(version_) != '1') continue;
      element.attributes.push_back({std::string(attribute.name), defaultText(attribute.row), position});
    }
    for (const Schema::Part* child : requiredChildren(*part.type, "1")) {
      element.children.push_back(defaultElement(*child, position));
    }
    return element;
  }

  void dropUnknownAttributes(Element& element, const Schema::ElementType& type) const {
    std::erase_if(element.attributes, [this, &type](const Element::Attribute& attribute) {
      if (attribute.name.find(':') != std::string::npos) return false;
      const Schema::Part* part = find(type.attributes, attribute.name);
      return part == nullptr || (attribute.value.empty() && part->row.presence.in(version_) != '1');
    });
  }

  int version_;
};

}  // namespace

void addDefaultElements(Element& sdf, int version) { Completion(version).complete(sdf, Schema::instance().root()); }

}  // namespace pongsim::sdf
