#include "urdf/extensions.hh"

#include <algorithm>
#include <cctype>
#include <span>

#include "base/element_edit.hh"
#include "base/nearest_word.hh"
#include "urdf/pose_element.hh"

namespace pongsim::urdf {

namespace {

/// An element of <gazebo> and the path in SDF that it stands for ("surface/friction/ode/mu").
struct ShortForm {
  std::string_view name;
  std::string_view path;
};

constexpr ShortForm kCollisionFields[] = {{"mu1", "surface/friction/ode/mu"},
                                          {"mu2", "surface/friction/ode/mu2"},
                                          {"fdir1", "surface/friction/ode/fdir1"},
                                          {"kp", "surface/contact/ode/kp"},
                                          {"kd", "surface/contact/ode/kd"},
                                          {"maxVel", "surface/contact/ode/max_vel"},
                                          {"minDepth", "surface/contact/ode/min_depth"},
                                          {"laserRetro", "laser_retro"},
                                          {"maxContacts", "max_contacts"}};
constexpr ShortForm kJointFields[] = {{"stopCfm", "physics/ode/limit/cfm"},
                                      {"stopErp", "physics/ode/limit/erp"},
                                      {"fudgeFactor", "physics/ode/fudge_factor"},
                                      {"springReference", "axis/dynamics/spring_reference"},
                                      {"springStiffness", "axis/dynamics/spring_stiffness"}};
constexpr std::string_view kLinkNames[] = {"material",    "turnGravityOff", "dampingFactor",
                                           "selfCollide", "collision",      "visual"};
constexpr std::string_view kJointNames[] = {"provideFeedback", "implicitSpringDamper", "cfmDamping"};
constexpr std::string_view kFixingNames[] = {"disableFixedJointLumping", "preserveFixedJoint"};
constexpr std::string_view kModelNames[] = {"static"};
// without effect since the old versions of Gazebo Classic
constexpr std::string_view kIdleNames[] = {"canonicalBody"};

bool isOneOf(std::string_view name, std::span<const std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}
const ShortForm* fieldOf(std::string_view name, std::span<const ShortForm> fields) {
  const auto found = std::ranges::find(fields, name, &ShortForm::name);
  return found != fields.end() ? &*found : nullptr;
}
bool isForLinks(std::string_view name) {
  return isOneOf(name, kLinkNames) || fieldOf(name, kCollisionFields) != nullptr;
}
bool isForJoints(std::string_view name) { return isOneOf(name, kJointNames) || fieldOf(name, kJointFields) != nullptr; }
/// @return Whether an element is SDF and is inserted as it is.
bool isVerbatim(std::string_view name) {
  return !isForLinks(name) && !isForJoints(name) && !isOneOf(name, kFixingNames) && !isOneOf(name, kModelNames) &&
         !isOneOf(name, kIdleNames);
}

/// Old files write <mu1 value="0.2"/>.
std::string valueOf(const Element& field) { return field.attributeOr("value", field.text); }

bool isSet(const Element& field) {
  std::string value = valueOf(field);
  std::ranges::transform(value, value.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return value == "true" || value == "yes" || value == "1";
}

void put(const Element& field, std::string_view path, std::string value, Element& target) {
  Element* parent = &target;
  for (std::size_t slash = path.find('/'); slash != path.npos; slash = path.find('/')) {
    parent = &base::childOrNew(*parent, path.substr(0, slash), field.position);
    path.remove_prefix(slash + 1);
  }
  base::setChild(*parent, path, field.position, std::move(value));
}

void putFields(const Element& gazebo, std::span<const ShortForm> fields, Element& target) {
  for (const Element& child : gazebo.children) {
    if (const ShortForm* field = fieldOf(child.name, fields)) put(child, field->path, valueOf(child), target);
  }
}

/// Copies the content of the <collision> or <visual> of an extension. An element with the name `unique` replaces an
/// existing one.
void copyContents(const Element& gazebo, std::string_view kind, std::string_view unique, Element& target) {
  for (const Element& child : gazebo.children) {
    if (child.name != kind) continue;
    for (const Element& content : child.children) {
      if (content.name == unique) std::erase_if(target.children, [&](const Element& e) { return e.name == unique; });
      target.children.push_back(content);
    }
  }
}

/// Makes the pose of a sensor, light or projector relative to the frame of its link, which stays when the link becomes
/// part of another.
void keepInFrame(const std::string& link, Element& part) {
  constexpr std::string_view kKinds[] = {"sensor", "light", "projector"};
  if (!isOneOf(part.name, kKinds)) return;
  Element& pose = base::childOrNew(part, "pose", part.position);
  if (pose.attribute("relative_to") == nullptr) base::setAttribute(pose, "relative_to", link, pose.position);
}

}  // namespace

Extensions::Extensions(const Element& robot) : robot_(robot) {
  for (const Element& child : robot.children) {
    if (child.name == "gazebo") lists_[child.attributeOr("reference", "")].push_back(&child);
  }
}

const Extensions::List& Extensions::of(const std::string& reference) const {
  static const List kNone;
  const auto found = lists_.find(reference);
  return found != lists_.end() ? found->second : kNone;
}

void Extensions::check(Diagnostics& diagnostics) const {
  std::unordered_map<std::string_view, std::string_view> kinds;
  std::vector<std::string_view> names;
  for (const Element& child : robot_.children) {
    const Element::Attribute* name = child.attribute("name");
    if ((child.name != "link" && child.name != "joint") || name == nullptr) continue;
    kinds.emplace(name->value, child.name);
    names.push_back(name->value);
  }
  for (const Element& gazebo : robot_.children) {
    if (gazebo.name != "gazebo") continue;
    const Element::Attribute* reference = gazebo.attribute("reference");
    const std::string name = reference != nullptr ? reference->value : "";
    const auto kind = kinds.find(name);
    if (!name.empty() && kind == kinds.end()) {
      diagnostics.warning(reference->position, "<gazebo> refers to '" + name + "', which is not a link or joint",
                          base::didYouMean(name, names));
      continue;
    }
    const std::string_view place = name.empty() ? "robot" : kind->second;
    for (const Element& child : gazebo.children) {
      std::string_view expected = place;
      if (isForLinks(child.name)) expected = "link";
      if (isForJoints(child.name) || isOneOf(child.name, kFixingNames)) expected = "joint";
      if (isOneOf(child.name, kModelNames)) expected = "robot";
      if (expected == place) continue;
      const std::string owner = name.empty() ? "the robot" : std::string(place) + " '" + name + "'";
      diagnostics.warning(child.position, "<" + child.name + "> has no effect on " + owner,
                          expected == "robot"
                              ? "put it in a <gazebo> without a reference"
                              : "put it in <gazebo reference=\"...\"> with the name of a " + std::string(expected));
    }
  }
}

Extensions::Fixing Extensions::fixingOf(const std::string& joint) const {
  Fixing fixing = Fixing::kLumped;
  for (const Element* gazebo : of(joint)) {
    for (const Element& child : gazebo->children) {
      if (!isOneOf(child.name, kFixingNames) || !isSet(child)) continue;
      if (child.name == "preserveFixedJoint") return Fixing::kKept;
      fixing = Fixing::kTurnedRevolute;
    }
  }
  return fixing;
}

void Extensions::addToCollision(const std::string& link, Element& collision) const {
  for (const Element* gazebo : of(link)) {
    copyContents(*gazebo, "collision", "surface", collision);
    putFields(*gazebo, kCollisionFields, collision);
  }
}

void Extensions::addToVisual(const std::string& link, Element& visual) const {
  for (const Element* gazebo : of(link)) {
    copyContents(*gazebo, "visual", "material", visual);
    const Element* material = gazebo->child("material");
    if (material == nullptr) continue;
    put(*material, "material/script/name", valueOf(*material), visual);
    put(*material, "material/script/uri", "file://media/materials/scripts/gazebo.material", visual);
  }
}

void Extensions::addToLink(const std::string& link, Element& target) const {
  const bool isLumped = target.attributeOr("name", "") != link;
  for (const Element* gazebo : of(link)) {
    for (const Element& child : gazebo->children) {
      if (child.name == "turnGravityOff") put(child, "gravity", isSet(child) ? "false" : "true", target);
      if (child.name == "selfCollide") put(child, "self_collide", isSet(child) ? "true" : "false", target);
      if (child.name == "dampingFactor") {
        put(child, "velocity_decay/linear", valueOf(child), target);
        put(child, "velocity_decay/angular", valueOf(child), target);
      }
      if (!isVerbatim(child.name)) continue;
      target.children.push_back(child);
      if (isLumped) keepInFrame(link, target.children.back());
    }
  }
}

void Extensions::addToJoint(const std::string& joint, Element& element) const {
  for (const Element* gazebo : of(joint)) {
    putFields(*gazebo, kJointFields, element);
    for (const Element& child : gazebo->children) {
      const std::string flag = isSet(child) ? "true" : "false";
      if (child.name == "provideFeedback") {
        put(child, "physics/provide_feedback", flag, element);
      } else if (child.name == "implicitSpringDamper" || child.name == "cfmDamping") {
        put(child, "physics/ode/implicit_spring_damper", flag, element);
      } else if (isVerbatim(child.name)) {
        element.children.push_back(child);
      }
    }
  }
}

void Extensions::addToModel(Element& model) const {
  // Fortress's converter warns about this for every robot with such an extension
  for (const Element* gazebo : of("")) {
    const Element* flag = gazebo->child("static");
    if (flag != nullptr || model.child("static") == nullptr) {
      put(flag != nullptr ? *flag : *gazebo, "static", flag != nullptr && isSet(*flag) ? "true" : "false", model);
    }
    for (const Element& child : gazebo->children) {
      if (isVerbatim(child.name)) model.children.push_back(child);
    }
  }
}

bool Extensions::namesInModel(const std::string& name) const {
  return std::ranges::any_of(of(""), [&](const Element* gazebo) {
    return std::ranges::any_of(gazebo->children, [&](const Element& child) {
      return child.name != "plugin" && isVerbatim(child.name) && child.attributeOr("name", "") == name;
    });
  });
}

}  // namespace pongsim::urdf
