#include "urdf/robot_check.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/nearest_word.hh"
#include "base/parse_number.hh"

namespace pongsim::urdf {

namespace {

struct Attribute {
  std::string_view name;
  /// How many numbers it has; 0: a text.
  std::size_t count;
  bool isRequired;
};

struct Rule {
  std::string_view element;
  std::vector<Attribute> attributes;
  std::vector<std::string_view> children;
  std::vector<std::string_view> required;
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> kRules = {
      {"link", {}, {"inertial", "visual", "collision"}, {}},
      {"inertial", {}, {"origin", "mass", "inertia"}, {"mass", "inertia"}},
      {"origin", {{"xyz", 3, false}, {"rpy", 3, false}}, {}, {}},
      {"mass", {{"value", 1, true}}, {}, {}},
      {"inertia",
       {{"ixx", 1, true}, {"ixy", 1, true}, {"ixz", 1, true}, {"iyy", 1, true}, {"iyz", 1, true}, {"izz", 1, true}},
       {},
       {}},
      {"visual", {}, {"origin", "geometry", "material"}, {"geometry"}},
      {"collision", {}, {"origin", "geometry"}, {"geometry"}},
      {"geometry", {}, {"box", "cylinder", "sphere", "mesh"}, {}},
      {"box", {{"size", 3, true}}, {}, {}},
      {"cylinder", {{"radius", 1, true}, {"length", 1, true}}, {}, {}},
      {"sphere", {{"radius", 1, true}}, {}, {}},
      {"mesh", {{"filename", 0, true}, {"scale", 3, false}}, {}, {}},
      {"material", {{"name", 0, true}}, {"color", "texture"}, {}},
      {"color", {{"rgba", 4, true}}, {}, {}},
      {"texture", {{"filename", 0, true}}, {}, {}},
      {"joint",
       {{"type", 0, true}},
       {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic", "safety_controller", "calibration"},
       {"parent", "child"}},
      {"axis", {{"xyz", 3, true}}, {}, {}},
      {"limit", {{"effort", 1, true}, {"velocity", 1, true}, {"lower", 1, false}, {"upper", 1, false}}, {}, {}},
      {"dynamics", {{"damping", 1, false}, {"friction", 1, false}}, {}, {}},
      {"mimic", {{"joint", 0, true}, {"multiplier", 1, false}, {"offset", 1, false}}, {}, {}},
      {"safety_controller",
       {{"k_velocity", 1, true},
        {"k_position", 1, false},
        {"soft_lower_limit", 1, false},
        {"soft_upper_limit", 1, false}},
       {},
       {}},
      {"calibration", {{"rising", 1, false}, {"falling", 1, false}, {"reference_position", 1, false}}, {}, {}},
  };
  return kRules;
}

constexpr std::array<std::string_view, 6> kJointTypes{"revolute", "continuous", "prismatic",
                                                      "fixed",    "floating",   "planar"};

std::string labelOf(const Element& part) {
  const Element::Attribute* name = part.attribute("name");
  return name != nullptr ? part.name + " '" + name->value + "'" : "a " + part.name;
}

/// Checks one link, joint or material and everything below it.
class PartCheck {
 public:
  PartCheck(const Element& part, Diagnostics& diagnostics) : label_(labelOf(part)), diagnostics_(diagnostics) {
    check(part);
    if (part.name == "joint") checkJoint(part);
  }
  bool isSound() const { return isSound_; }

 private:
  void fail(const SourcePosition& position, std::string message, std::string hint = {}) {
    isSound_ = false;
    diagnostics_.error(position, std::move(message), std::move(hint));
  }

  void check(const Element& element) {
    const auto rule = std::ranges::find(rules(), element.name, &Rule::element);
    if (rule == rules().end()) return;
    for (const Attribute& attribute : rule->attributes) checkAttribute(element, attribute);
    for (const std::string_view child : rule->required) {
      if (element.child(child) != nullptr) continue;
      const std::string owner = element.name == "joint" ? label_ : "the <" + element.name + "> of " + label_;
      fail(element.position, owner + " has no <" + std::string(child) + ">");
    }
    if (element.name == "geometry") return checkGeometry(element, rule->children);
    for (const Element& child : element.children) {
      if (std::ranges::find(rule->children, child.name) != rule->children.end()) {
        check(child);
      } else if (const std::string hint = base::didYouMean(child.name, rule->children); !hint.empty()) {
        diagnostics_.warning(child.position, "<" + child.name + "> is unknown in URDF: it is ignored", hint);
      }
    }
  }

  void checkGeometry(const Element& geometry, std::span<const std::string_view> shapes) {
    if (geometry.children.empty()) return fail(geometry.position, "<geometry> of " + label_ + " has no shape");
    const Element& shape = geometry.children.front();
    if (std::ranges::find(shapes, shape.name) != shapes.end()) return check(shape);
    const std::string hint = base::didYouMean(shape.name, shapes);
    fail(shape.position, "<" + shape.name + "> is not a shape of URDF",
         hint.empty() ? "the shapes are box, cylinder, sphere and mesh" : hint);
  }

  void checkAttribute(const Element& element, const Attribute& rule) {
    const std::string name(rule.name);
    const Element::Attribute* attribute = element.attribute(rule.name);
    if (attribute == nullptr) {
      if (rule.isRequired) fail(element.position, missing(element, name), spelling(element, rule.name));
      return;
    }
    if (rule.count == 0) return;
    const std::optional<std::vector<double>> values = base::parseDoubles(attribute->value);
    const bool areFinite = values && std::ranges::all_of(*values, [](double value) { return std::isfinite(value); });
    if (areFinite && values->size() == rule.count) return;
    const std::string expected = rule.count == 1 ? "a finite number" : std::to_string(rule.count) + " finite numbers";
    fail(attribute->position,
         "attribute '" + name + "' of <" + element.name + "> is '" + attribute->value + "', which is not " + expected);
  }

  std::string missing(const Element& element, const std::string& attribute) const {
    const bool isPart = element.name == "joint" || element.name == "link";
    return (isPart ? label_ : "<" + element.name + "> of " + label_) + " has no attribute '" + attribute + "'";
  }

  static std::string spelling(const Element& element, std::string_view expected) {
    for (const Element::Attribute& attribute : element.attributes) {
      const std::array<std::string_view, 1> known{expected};
      if (!base::nearestWord(attribute.name, known).empty()) return "it has '" + attribute.name + "'";
    }
    return {};
  }

  void checkJoint(const Element& joint) {
    const Element::Attribute* type = joint.attribute("type");
    if (type == nullptr) return;
    if (std::ranges::find(kJointTypes, type->value) == kJointTypes.end()) {
      const std::string hint = base::didYouMean(type->value, kJointTypes);
      return fail(type->position, label_ + " has the unknown type '" + type->value + "'",
                  hint.empty() ? "the types are revolute, continuous, prismatic, fixed, floating and planar" : hint);
    }
    const bool needsLimit = type->value == "revolute" || type->value == "prismatic";
    if (needsLimit && joint.child("limit") == nullptr) {
      fail(joint.position, label_ + " is " + type->value + " and has no <limit>",
           type->value == "revolute" ? "for a joint without limits, use type 'continuous'" : "");
    }
  }

  const std::string label_;
  Diagnostics& diagnostics_;
  bool isSound_ = true;
};

}  // namespace

bool checkRobot(const Element& robot, Diagnostics& diagnostics) {
  constexpr std::array<std::string_view, 3> kParts{"link", "joint", "material"};
  bool isSound = true;
  for (const Element& part : robot.children) {
    if (std::ranges::find(kParts, part.name) != kParts.end()) {
      isSound = PartCheck(part, diagnostics).isSound() && isSound;
    } else if (const std::string hint = base::didYouMean(part.name, kParts); !hint.empty()) {
      diagnostics.warning(part.position, "<" + part.name + "> is unknown in URDF: it is ignored", hint);
    }
  }
  return isSound;
}

}  // namespace pongsim::urdf
