#include "sdf/upgrade.hh"

#include <algorithm>
#include <array>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/element_edit.hh"
#include "sdf/includes/unflatten.hh"
#include "sdf/schema/schema.hh"
#include "sdf/text/names.hh"
#include "sdf/text/values.hh"
#include "sdf/version.hh"

namespace pongsim::sdf {

namespace {

/// Calls `take` with each element with this name, except in plugins.
template <class Take>
void forEach(Element& element, std::string_view name, const Take& take) {
  for (Element& child : element.children) {
    if (child.name == name) take(child);
    if (child.name != "plugin") forEach(child, name, take);
  }
}

/// Calls `take` with each axis of each joint.
template <class Take>
void forEachAxis(Element& root, const Take& take) {
  forEach(root, "joint", [&take](Element& joint) {
    for (Element& child : joint.children) {
      if (child.name == "axis" || child.name == "axis2") take(child);
    }
  });
}

/// To SDF 1.5, which has a flag for axes in the model's frame. In older versions all of them are.
void flagAxes(Element& root) {
  forEachAxis(root, [](Element& axis) {
    constexpr std::string_view kFlag = "use_parent_model_frame";
    if (axis.child(kFlag) == nullptr) base::addChild(axis, kFlag, axis.position, "true");
  });
}

/// To SDF 1.6, where gravity and the magnetic field belong to the world.
void movePhysics(Element& root) {
  for (Element& world : root.children) {
    Element* physics = world.name == "world" ? base::childOf(world, "physics") : nullptr;
    if (physics == nullptr) continue;
    std::vector<Element> moved;
    for (const std::string_view name : {"gravity", "magnetic_field"}) {
      const Element* child = physics->child(name);
      if (child == nullptr || world.child(name) != nullptr) continue;
      moved.push_back(*child);
      std::erase_if(physics->children, [name](const Element& each) { return each.name == name; });
    }
    std::ranges::move(moved, std::back_inserter(world.children));
  }
}

/// To SDF 1.6, where each axis of an IMU has its own noise.
void splitImuNoise(Element& root) {
  forEach(root, "imu", [](Element& imu) {
    const Element* found = imu.child("noise");
    if (found == nullptr) return;
    const Element noise = *found;
    constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kParts{
        {{"rate", "angular_velocity"}, {"accel", "linear_acceleration"}}};
    for (const auto& [from, to] : kParts) {
      const Element* parameters = noise.child(from);
      for (const std::string_view axis : {"x", "y", "z"}) {
        Element& vector = base::childOrNew(imu, to, imu.position);
        Element& component = base::childOrNew(vector, axis, vector.position);
        Element& target = base::childOrNew(component, "noise", component.position);
        target.attributes.push_back({"type", std::string(childText(noise, "type")), noise.position});
        if (parameters != nullptr) target.children = parameters->children;
      }
    }
    std::erase_if(imu.children, [](const Element& child) { return child.name == "noise"; });
  });
}

/// To SDF 1.7, where a pose names its frame in another attribute.
void renamePoseFrames(Element& root) {
  forEach(root, "pose", [](Element& pose) {
    if (pose.attribute("relative_to") != nullptr) return;
    for (Element::Attribute& attribute : pose.attributes) {
      if (attribute.name == "frame") attribute.name = "relative_to";
    }
  });
}

/// To SDF 1.7, where an axis names the frame that it is given in.
void nameAxisFrames(Element& root, Context& context) {
  forEachAxis(root, [&context](Element& axis) {
    constexpr std::string_view kFlag = "use_parent_model_frame";
    const Element* flag = axis.child(kFlag);
    if (flag == nullptr) return;
    const SourcePosition position = flag->position;
    const bool isInModel = readFlag(axis, kFlag, false, context);
    std::erase_if(axis.children, [kFlag](const Element& child) { return child.name == kFlag; });
    if (!isInModel) return;
    Element& xyz = base::childOrNew(axis, "xyz", axis.position);
    if (xyz.attribute("expressed_in") == nullptr) {
      xyz.attributes.push_back({"expressed_in", std::string(kModelFrame), position});
    }
  });
}

/// To SDF 1.7, where the frames of a model or world must have different names. Later ones get the new name that
/// Fortress gives them.
void separateNames(Element& holder, Context& context) {
  std::set<std::pair<std::string, std::string>> kindAndName;
  std::set<std::string> taken;
  for (const Element* include : holder.childrenNamed("include")) taken.emplace(childText(*include, "name"));
  for (const std::string_view kind : {"model", "link", "joint", "frame"}) {
    for (Element& child : holder.children) {
      if (child.name != kind) continue;
      Element::Attribute* const attribute = base::attributeOf(child, "name");
      if (attribute == nullptr || attribute->value.empty()) continue;
      const std::string old = attribute->value;
      // two of the same kind with one name are an error in any version
      if (!kindAndName.emplace(child.name, old).second || taken.insert(old).second) continue;
      std::string name = old + "_" + child.name;
      for (int i = 0; !taken.insert(name).second; ++i) name = old + "_" + child.name + std::to_string(i);
      context.diagnostics.warning(attribute->position,
                                  child.name + " '" + old + "' has the same name as another part of its " +
                                      holder.name + ": it is renamed to '" + name + "'",
                                  "as in Fortress; from SDF 1.7 this is an error");
      attribute->value = name;
    }
  }
}

void separateAllNames(Element& element, Context& context) {
  for (Element& child : element.children) {
    if (child.name != "world" && child.name != "model") continue;
    separateNames(child, context);
    separateAllNames(child, context);
  }
}

void warnOfRemoved(const std::string& label, const SourcePosition& position, const Schema::Part& part,
                   const Element& holder, Context& context) {
  if (part.row.removedIn <= context.version || !context.firstTime("removed " + label)) return;
  context.diagnostics.warning(position, label + " has no effect in <" + holder.name + ">",
                              "SDF 1." + std::to_string(part.row.removedIn) + " removed it");
}

/// From SDF 1.10 on, a screw's thread has a name that says its unit, metres per turn. Fortress takes `<thread_pitch>`
/// for that, but libsdformat from 1.10 on reads it like Gazebo Classic: in radians per metre, left-handed.
void renameThreads(Element& root, Context& context) {
  forEach(root, "joint", [&context](Element& joint) {
    Element* thread = base::childOf(joint, "thread_pitch");
    if (thread == nullptr || joint.child("screw_thread_pitch") != nullptr) return;
    double pitch = readNumber(joint, "thread_pitch", 1, context);
    if (context.version > kFortressVersion) {
      if (pitch == 0) {
        context.diagnostics.error(thread->position, "<thread_pitch> is 0",
                                  "<screw_thread_pitch> is the distance per turn in metres");
        return;
      }
      pitch = -2 * std::numbers::pi / pitch;
    }
    thread->name = "screw_thread_pitch";
    thread->text = base::shortestText(pitch);
  });
}

/// Removes, or only reports, what the version after the upgrade no longer has.
void dropRemoved(Element& element, const Schema::ElementType& type, RemovedUse use, int version, Context& context) {
  const auto isRemoved = [version](const Schema::Part& part) { return part.row.isGoneIn(version); };
  // most elements have no attribute that was removed, so this check saves time
  if (std::ranges::any_of(type.attributes, isRemoved)) {
    std::erase_if(element.attributes, [&](const Element::Attribute& attribute) {
      const Schema::Part* part = Schema::find(type.attributes, attribute.name);
      if (part == nullptr || !isRemoved(*part)) return false;
      if (!attribute.value.empty()) {
        warnOfRemoved("attribute '" + attribute.name + "'", attribute.position, *part, element, context);
      }
      return true;
    });
  }
  std::size_t kept = 0;
  for (Element& child : element.children) {
    const Schema::Part* part = Schema::find(type.children, child.name);
    if (part != nullptr && isRemoved(*part)) {
      warnOfRemoved("<" + child.name + ">", child.position, *part, element, context);
      if (use == RemovedUse::kDrop) continue;
    } else if (part != nullptr && part->type != nullptr && !part->isFreeForm) {
      dropRemoved(child, *part->type, use, version, context);
    }
    Element& place = element.children[kept++];
    if (&place != &child) place = std::move(child);
  }
  element.children.resize(kept);
}

}  // namespace

void upgrade(Element& root, Context& context, RemovedUse removed, int least) {
  const int version = context.version;
  const int target = std::max(least, upgradedVersion(version));
  if (version < 5) flagAxes(root);
  if (version < 6) {
    movePhysics(root);
    splitImuNoise(root);
  }
  if (version < 7) {
    renamePoseFrames(root);
    nameAxisFrames(root, context);
    separateAllNames(root, context);
  }
  if (version < 8) unflattenAll(root, context);
  if (target > kFortressVersion) renameThreads(root, context);
  dropRemoved(root, *Schema::instance().root().type, removed, target, context);
  for (Element::Attribute& attribute : root.attributes) {
    if (attribute.name == "version") attribute.value = "1." + std::to_string(target);
  }
}

}  // namespace pongsim::sdf
