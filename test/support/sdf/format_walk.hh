#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sdf/schema/schema.hh"

namespace pongsim::sdf::test {

/// Two values of each type of the format.
inline std::pair<std::string, std::string> valuesOfType(std::string_view type) {
  if (type == "bool") return {"true", "false"};
  if (type == "int" || type == "unsigned int") return {"2", "3"};
  if (type == "double" || type == "float") return {"0.125", "0.25"};
  if (type == "vector2d") return {"1 2", "2 1"};
  if (type == "vector3") return {"1 2 3", "3 2 1"};
  if (type == "color") return {"0.1 0.2 0.3 1", "0.3 0.2 0.1 1"};
  if (type == "pose") return {"1 2 3 0 0 0", "3 2 1 0 0 0"};
  if (type == "time") return {"1 2", "2 1"};
  return {"one", "two"};
}

/// What an element needs besides the part under test, so that a file with it is valid.
struct NeededContent {
  std::string attributes;
  std::string children;
};

inline const std::map<std::string_view, std::string_view> kTypeOfSensorPart = {
    {"air_pressure", "air_pressure"},
    {"altimeter", "altimeter"},
    {"contact", "contact"},
    {"force_torque", "force_torque"},
    {"gps", "gps"},
    {"imu", "imu"},
    {"lidar", "lidar"},
    {"logical_camera", "logical_camera"},
    {"magnetometer", "magnetometer"},
    {"navsat", "navsat"},
    {"ray", "lidar"},
    {"rfid", "rfid"},
    {"rfidtag", "rfidtag"},
    {"sonar", "sonar"},
    {"transceiver", "wireless_receiver"},
};

/// @param parent Name of the element's parent.
/// @param next Name of the child that is or contains the part under test; empty if that is an attribute or the text.
/// @param attribute Name of the attribute under test, if it is one of this element.
inline NeededContent neededIn(std::string_view name, std::string_view parent, std::string_view next,
                              std::string_view attribute) {
  NeededContent needed;
  constexpr std::string_view kLinks =
      "<link name='a'/><link name='b'><pose>0 0 1 0 0 0</pose></link>"
      "<frame name='f'><pose>1 0 0 0.5 0 0</pose></frame>";
  const bool isInWorld = parent == "world";
  const std::string scope = isInWorld ? "m::" : "";
  // joints that an axis can mimic
  const auto leaders = [](const std::string& prefix) {
    const std::string ends = "<parent>" + prefix + "a</parent><child>" + prefix + "b</child><axis/>";
    return "<joint name='leader' type='universal'>" + ends + "<axis2><xyz>1 0 0</xyz></axis2></joint>" +
           "<joint name='other' type='revolute'>" + ends + "</joint>";
  };
  if (name == "model") needed.children = kLinks;
  if (name == "mimic" && attribute != "joint") needed.attributes = " joint='leader'";
  if (name == "link" && next == "inertial") {
    needed.children = "<collision name='c'><geometry><box/></geometry></collision>";
  }
  if (name == "link" && next == "collision") needed.children = "<inertial auto='true'/>";
  if (name == "inertial" && next == "density") needed.attributes = " auto='true'";
  if (name == "world") {
    needed.children =
        "<frame name='f'><pose>1 0 0 0.5 0 0</pose></frame><model name='m'>" + std::string(kLinks) + "</model>";
  }
  if ((name == "model" || name == "world") && next == "joint") needed.children += leaders(name == "world" ? "m::" : "");
  if (name == "joint") {
    const std::string_view type = next == "axis2"                  ? "universal"
                                  : next.ends_with("thread_pitch") ? "screw"
                                  : next.starts_with("gearbox")    ? "gearbox"
                                                                   : "revolute";
    if (attribute != "type") needed.attributes = " type='" + std::string(type) + "'";
    if (next != "parent")
      needed.children += next == "child" ? "<parent>world</parent>" : "<parent>" + scope + "a</parent>";
    if (next != "child") needed.children += "<child>" + scope + "b</child>";
    if (next == "gearbox_ratio") needed.children += "<gearbox_reference_body>world</gearbox_reference_body>";
  }
  if (name == "sensor" && attribute != "type") {
    const auto type = kTypeOfSensorPart.find(next);
    needed.attributes = " type='" + std::string(type != kTypeOfSensorPart.end() ? type->second : "camera") + "'";
  }
  if ((name == "collision" || name == "visual") && next != "geometry") {
    needed.children = "<geometry><box/></geometry>";
  }
  if (name == "polyline") needed.children = "<point>0 0</point><point>1 0</point><point>1 1</point>";
  if (name == "custom_rpy") {
    needed.children = "0 0 1";
    if (attribute != "parent_frame") needed.attributes = " parent_frame='world'";
  }
  if (name == "pose" && !attribute.empty()) {
    needed.children = attribute == "rotation_format" ? "0 0 0 0 0 1 0" : "0 0 0 0 0 1";
  }
  if (name == "model" && attribute == "placement_frame") needed.children += "<pose>0 0 0 0 0 0</pose>";
  if (name == "xyz" && !attribute.empty()) needed.children = "0 1 1";
  return needed;
}

/// A place of an element or attribute in SDF 1.9.
struct Place {
  /// The elements from `<sdf>` down to the element, or to the one with the attribute.
  std::vector<const Schema::Part*> chain;
  /// Null: the place is that of the chain's last element.
  const Schema::Part* attribute = nullptr;
  /// Its use by the table; if one of the elements around it is not read, that one's.
  Use use = Use::kRead;

  const Schema::Part& part() const { return attribute != nullptr ? *attribute : *chain.back(); }
};

inline std::string requiredAttributes(const Schema::ElementType& type, const std::string& given,
                                      std::string_view tested) {
  std::string text;
  for (const Schema::Part& part : type.attributes) {
    const std::string name(part.name);
    const bool isGiven = part.name == tested || given.find(" " + name + "=") != given.npos;
    if (part.row.presence.in(9) != '1' || part.row.removedIn != 0 || isGiven) continue;
    const std::string value = part.name == "version"             ? "1.9"
                              : !part.row.fallback.value.empty() ? std::string(part.row.fallback.value)
                                                                 : valuesOfType(part.row.type).first;
    text += " " + name + "='" + value + "'";
  }
  return text;
}

/// @return A valid file with this value at the place, which is in line 2.
inline std::string documentWith(const Place& place, const std::string& value) {
  std::string before, behind;
  for (std::size_t i = 0; i < place.chain.size(); ++i) {
    const Schema::Part& part = *place.chain[i];
    const bool isLast = i + 1 == place.chain.size();
    const std::string_view next = isLast ? "" : place.chain[i + 1]->name;
    const std::string_view tested = isLast && place.attribute != nullptr ? place.attribute->name : "";
    const std::string name(part.name == "*" ? "anything" : part.name);
    const NeededContent needed = neededIn(name, i > 0 ? place.chain[i - 1]->name : "", next, tested);
    before += (isLast ? "\n<" : "<") + name + needed.attributes;
    if (part.type != nullptr) before += requiredAttributes(*part.type, needed.attributes, tested);
    if (!tested.empty()) before += " " + std::string(tested) + "='" + value + "'";
    before += ">";
    if (!isLast || place.attribute != nullptr) before += needed.children;
    behind = "</" + name + ">" + behind;
  }
  return before + (place.attribute == nullptr ? value : "") + behind;
}

/// Calls `visit` with every place of SDF 1.9 except elements without a value, elements inside one of their own type,
/// and includes.
class FormatWalk {
 public:
  using Visit = std::function<void(const Place&)>;

  explicit FormatWalk(Visit visit) : visit_(std::move(visit)) {
    place_.chain.push_back(&Schema::instance().root());
    descend(Use::kRead);
  }

 private:
  void descend(Use use) {
    const Schema::ElementType* type = place_.chain.back()->type;
    if (type == nullptr) return;
    for (const Schema::Part& attribute : type->attributes) {
      if (attribute.row.removedIn != 0) continue;
      place_.attribute = &attribute;
      visitAs(combined(use, attribute.row.use));
      place_.attribute = nullptr;
    }
    for (const Schema::Part& child : type->children) {
      const bool isWithinItself = child.type != nullptr && std::ranges::find(place_.chain, child.type,
                                                                             &Schema::Part::type) != place_.chain.end();
      // an include needs another file
      if (child.row.removedIn != 0 || isWithinItself || child.name == "include") continue;
      place_.chain.push_back(&child);
      const Use childUse = combined(use, child.row.use);
      if (!child.row.type.empty() || child.name == "*") visitAs(childUse);
      descend(childUse);
      place_.chain.pop_back();
    }
  }

  static Use combined(Use outer, Use inner) { return outer == Use::kRead ? inner : outer; }

  void visitAs(Use use) {
    place_.use = use;
    visit_(place_);
  }

  Visit visit_;
  Place place_;
};

}  // namespace pongsim::sdf::test
