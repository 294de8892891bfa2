#include "cli/model/model_text.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/model/sensor_text.hh"

namespace pongsim::cli {

namespace {

using ModelJson = nlohmann::ordered_json;
using msgs::EntityState;
using Kind = EntityState::Kind;

/// Formatted like `std::to_string`, with six decimals.
std::string decimals(double value) { return std::to_string(value); }

std::string row(const std::array<double, 3>& values) {
  return "[" + decimals(values[0]) + " " + decimals(values[1]) + " " + decimals(values[2]) + "]\n";
}

std::string streamedVector(const Vector3& vector) {
  std::string text;
  for (const double value : vector) {
    std::array<char, 32> number{};
    // anything smaller is rounding error
    std::snprintf(number.data(), number.size(), "%g", std::abs(value) < 1e-12 ? 0 : value);
    text += (text.empty() ? "" : " ") + std::string(number.data());
  }
  return text;
}

ModelJson jsonOfVector(const Vector3& vector) { return {vector.x(), vector.y(), vector.z()}; }

ModelJson jsonOfPose(const Pose& pose) {
  return {{"position", jsonOfVector(pose.position)}, {"rpy", jsonOfVector(rollPitchYawOf(pose.rotation))}};
}

/// @param name The user's choice; unset or empty: all.
bool isChosen(const std::optional<std::string>& name, const EntityState& entity) {
  return !name || name->empty() || *name == entity.name;
}

std::string idOf(const EntityState& entity) { return "[" + std::to_string(entity.id) + "]"; }

}  // namespace

/// Prints one model.
class ModelTeller::Printer {
 public:
  Printer(const ModelTeller& teller, const EntityState& model, const ModelParts& parts)
      : teller_(teller), model_(model), parts_(parts) {}

  std::string text() && {
    std::size_t indent = 0;
    if (parts_.areAll() || parts_.pose) {
      add(0, "Model: " + idOf(model_));
      add(2, "- Name: " + model_.name);
      addPose(2, model_);
      indent = 2;
    }
    if (parts_.areAll() || parts_.link || parts_.sensor) addLinks(indent);
    if (parts_.areAll() || parts_.joint || parts_.sensor) addJoints(indent);
    return std::move(text_);
  }

 private:
  void add(std::size_t indent, const std::string& line) { text_ += std::string(indent, ' ') + line + "\n"; }

  void addPose(std::size_t indent, const Pose& pose, const char* what = "- Pose") {
    const Vector3 angles = rollPitchYawOf(pose.rotation);
    add(indent, std::string(what) + " [ XYZ (m) ] [ RPY (rad) ]:");
    text_ += std::string(indent + 2, ' ') + row({pose.position.x(), pose.position.y(), pose.position.z()});
    text_ += std::string(indent + 2, ' ') + row({angles.x(), angles.y(), angles.z()});
  }
  void addPose(std::size_t indent, const EntityState& entity) {
    if (entity.pose) addPose(indent, *entity.pose);
  }
  void addHeader(std::size_t indent, const char* kind, const EntityState& entity) {
    add(indent, std::string("- ") + kind + " " + idOf(entity));
    add(indent + 2, "- Name: " + entity.name);
    add(indent + 2, "- Parent: " + model_.name + " " + idOf(model_));
  }

  /// A named sensor is printed alone, as by `ign model`; without a name, sensors follow their links.
  void addLinks(std::size_t indent) {
    const bool isAlone = parts_.sensor && !parts_.sensor->empty();
    for (const EntityState* link : teller_.childrenOf(model_.id, Kind::kLink)) {
      if (!isChosen(parts_.link, *link)) continue;
      if (!isAlone) addLink(indent, *link);
      addSensors(isAlone ? indent : indent + 2, *link);
    }
  }

  void addLink(std::size_t indent, const EntityState& link) {
    addHeader(indent, "Link", link);
    if (link.inertial) {
      const Matrix3& I = link.inertial->moments;
      add(indent + 2, "- Mass (kg): " + decimals(link.inertial->mass));
      addPose(indent + 2, link.inertial->X_LinkCom, "- Inertial Pose");
      add(indent + 2, "- Inertial Matrix (kg.m^2):");
      for (Eigen::Index i = 0; i < 3; ++i) {
        text_ += std::string(indent + 4, ' ') + row({I(i, 0), I(i, 1), I(i, 2)});
      }
    }
    addPose(indent + 2, link);
  }

  void addSensors(std::size_t indent, const EntityState& holder) {
    for (const EntityState* sensor : teller_.childrenOf(holder.id, Kind::kSensor)) {
      if (!isChosen(parts_.sensor, *sensor)) continue;
      addHeader(indent, "Sensor", *sensor);
      addPose(indent + 2, *sensor);
      if (sensor->sensor) text_ += sensorText(sensor->sensor->settings, static_cast<int>(indent + 2));
    }
  }

  void addJoints(std::size_t indent) {
    const bool areShown = parts_.areAll() || parts_.joint;
    for (const EntityState* joint : teller_.childrenOf(model_.id, Kind::kJoint)) {
      if (!isChosen(parts_.joint, *joint)) continue;
      if (areShown) addJoint(indent, *joint);
      if (parts_.areAll() || parts_.sensor) addSensors(areShown ? indent + 2 : indent, *joint);
    }
  }

  void addJoint(std::size_t indent, const EntityState& joint) {
    addHeader(indent, "Joint", joint);
    if (!joint.jointType.empty()) add(indent + 2, "- Type: " + joint.jointType);
    add(indent + 2, "- Parent Link: " + linkOf(joint.parentLink));
    add(indent + 2, "- Child Link: " + linkOf(joint.childLink));
    addPose(indent + 2, joint);
    for (const Vector3& axis : joint.axes) {
      add(indent + 2, "- Axis unit vector [ XYZ ]:");
      add(indent + 4, "[" + streamedVector(axis) + "]");
    }
  }

  /// @param name Relative to the model: "inner::link", or "world".
  /// @return "link [7]"
  std::string linkOf(const std::string& name) const {
    std::uint64_t holder = model_.id;
    std::string_view rest = name;
    for (std::size_t end = rest.find("::"); end != std::string_view::npos; end = rest.find("::")) {
      for (const EntityState* inner : teller_.childrenOf(holder, Kind::kModel)) {
        if (inner->name == rest.substr(0, end)) holder = inner->id;
      }
      rest.remove_prefix(end + 2);
    }
    for (const EntityState* link : teller_.childrenOf(holder, Kind::kLink)) {
      if (link->name == rest) return name + " " + idOf(*link);
    }
    return name;
  }

  const ModelTeller& teller_;
  const EntityState& model_;
  const ModelParts& parts_;
  std::string text_;
};

ModelTeller::ModelTeller(std::vector<EntityState> entities) : entities_(std::move(entities)) {}

const EntityState& ModelTeller::entity(std::uint64_t id) const {
  return *std::ranges::lower_bound(entities_, id, {}, &EntityState::id);
}

std::vector<const EntityState*> ModelTeller::childrenOf(std::uint64_t parent, Kind kind) const {
  std::vector<const EntityState*> children;
  for (const EntityState& each : entities_) {
    if (each.parent == parent && each.kind == kind) children.push_back(&each);
  }
  return children;
}

std::string ModelTeller::scopedName(const EntityState& model) const {
  for (const EntityState& holder : entities_) {
    if (holder.id == model.parent && holder.kind == Kind::kModel) return scopedName(holder) + "::" + model.name;
  }
  return model.name;
}

std::vector<std::string> ModelTeller::models() const {
  std::vector<std::string> names;
  for (const EntityState& world : entities_) {
    if (world.kind != Kind::kWorld) continue;
    for (const EntityState* model : childrenOf(world.id, Kind::kModel)) names.push_back(model->name);
  }
  return names;
}

std::optional<std::uint64_t> ModelTeller::find(const std::string& name) const {
  std::vector<std::uint64_t> nested;
  for (const EntityState& model : entities_) {
    if (model.kind != Kind::kModel) continue;
    if (scopedName(model) == name) return model.id;
    if (model.name == name) nested.push_back(model.id);
  }
  return nested.size() == 1 ? std::optional(nested.front()) : std::nullopt;
}

std::vector<std::string> ModelTeller::namesOf(std::uint64_t model, Kind kind) const {
  std::vector<std::string> names;
  if (kind != Kind::kSensor) {
    for (const EntityState* each : childrenOf(model, kind)) names.push_back(each->name);
    return names;
  }
  for (const Kind holder : {Kind::kLink, Kind::kJoint}) {
    for (const EntityState* each : childrenOf(model, holder)) {
      for (const EntityState* sensor : childrenOf(each->id, kind)) names.push_back(sensor->name);
    }
  }
  return names;
}

std::string ModelTeller::listText() const {
  std::string text = "Available models:\n";
  for (const std::string& model : models()) text += "    - " + model + "\n";
  return text;
}

std::string ModelTeller::text(std::uint64_t model, const ModelParts& parts) const {
  return Printer(*this, entity(model), parts).text();
}

std::string ModelTeller::listJson() const {
  ModelJson list = ModelJson::array();
  for (const EntityState& world : entities_) {
    if (world.kind != Kind::kWorld) continue;
    for (const EntityState* model : childrenOf(world.id, Kind::kModel)) {
      list.push_back({{"name", model->name}, {"id", model->id}, {"static", model->isStatic}});
    }
  }
  return list.dump() + "\n";
}

std::string ModelTeller::json(std::uint64_t id, const ModelParts& parts) const {
  const bool all = parts.areAll();
  const auto describe = [](const EntityState& each) {
    ModelJson json = {{"name", each.name}, {"id", each.id}};
    if (each.pose) json["pose"] = jsonOfPose(*each.pose);
    return json;
  };
  const auto sensorsOf = [&](const EntityState& holder) {
    ModelJson list = ModelJson::array();
    for (const EntityState* sensor : childrenOf(holder.id, Kind::kSensor)) {
      if (!isChosen(parts.sensor, *sensor)) continue;
      list.push_back(describe(*sensor));
      if (sensor->sensor) list.back()["type"] = sensor->sensor->type;
    }
    return list;
  };
  const EntityState& model = entity(id);
  ModelJson json = {{"name", model.name}, {"id", model.id}};
  if ((all || parts.pose) && model.pose) json["pose"] = jsonOfPose(*model.pose);
  if (all || parts.link || parts.sensor) json["links"] = ModelJson::array();
  if (all || parts.joint || parts.sensor) json["joints"] = ModelJson::array();
  for (const EntityState* link : childrenOf(id, Kind::kLink)) {
    if (!json.contains("links") || !isChosen(parts.link, *link)) continue;
    ModelJson& added = json["links"].emplace_back(describe(*link));
    if (link->inertial) {
      const Matrix3& I = link->inertial->moments;
      added["mass"] = link->inertial->mass;
      added["inertialPose"] = jsonOfPose(link->inertial->X_LinkCom);
      // symmetric
      added["inertia"] = {jsonOfVector(I.col(0)), jsonOfVector(I.col(1)), jsonOfVector(I.col(2))};
    }
    added["sensors"] = sensorsOf(*link);
  }
  for (const EntityState* joint : childrenOf(id, Kind::kJoint)) {
    if (!json.contains("joints") || !isChosen(parts.joint, *joint)) continue;
    ModelJson& added = json["joints"].emplace_back(describe(*joint));
    added["type"] = joint->jointType;
    added["parent"] = joint->parentLink;
    added["child"] = joint->childLink;
    added["axes"] = ModelJson::array();
    for (const Vector3& axis : joint->axes) added["axes"].push_back(jsonOfVector(axis));
    added["positions"] = joint->positions;
    added["velocities"] = joint->velocities;
    added["sensors"] = sensorsOf(*joint);
  }
  return json.dump() + "\n";
}

}  // namespace pongsim::cli
