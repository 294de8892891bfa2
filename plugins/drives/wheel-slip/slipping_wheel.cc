#include "slipping_wheel.hh"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/parameters.hh"

namespace pongsim {

namespace {

/// A slip beyond this is equivalent to no friction [m/s/N].
constexpr double kLargestSlip = 1e6;

double aboveZero(const Element& wheel, const char* name) {
  const std::optional<double> value = wheel.find<double>(name);
  if (!value) refuse(wheel, "<wheel> has no <" + std::string(name) + ">");
  if (!(*value > 0) || !std::isfinite(*value)) {
    refuse(*wheel.child(name), "<" + std::string(name) + "> must be above zero");
  }
  return *value;
}

double atLeastZero(const Element& wheel, const char* name) {
  const double value = wheel.get<double>(name, 0);
  if (!(value >= 0) || !std::isfinite(value)) {
    refuse(*wheel.child(name), "<" + std::string(name) + "> must be zero or more");
  }
  return value;
}

}  // namespace

void SlippingWheel::slip(const SlipCompliance& now) {
  const double scale = radius * std::abs(joint.velocity()) / load;
  collision.setSlip(std::min(scale * now.lateral, kLargestSlip), std::min(scale * now.longitudinal, kLargestSlip));
}

SlippingWheel slippingWheel(const Element& element, const Model& model) {
  const Element::Attribute* attribute = element.attribute("link_name");
  if (attribute == nullptr) refuse(element, "<wheel> has no link_name", "write <wheel link_name=\"LINK\">");
  const std::optional<Link> found = model.link(attribute->value);
  if (!found) {
    std::string names;
    for (const Link& other : model.links()) names += (names.empty() ? "" : ", ") + std::string(other.name());
    throw Error({Severity::kError, attribute->position,
                 "link_name '" + attribute->value + "' is not a link of model '" + std::string(model.name()) + "'",
                 "its links are " + names});
  }
  const Link link = *found;
  const std::string label = "link '" + attribute->value + "'";

  const std::vector<Collision> collisions = link.collisions();
  if (collisions.size() != 1) {
    refuse(element,
           label + " has " + std::to_string(collisions.size()) + " collisions: a slipping wheel must have one");
  }
  std::vector<Joint> joints = model.joints();
  std::erase_if(joints, [&](const Joint& joint) { return joint.child().id() != link.id(); });
  if (joints.size() != 1 || joints[0].axisCount() == 0) {
    refuse(element, label + " is not the child of exactly one joint with an axis");
  }
  return {link,
          collisions[0],
          joints[0],
          aboveZero(element, "wheel_radius"),
          aboveZero(element, "wheel_normal_force"),
          {atLeastZero(element, "slip_compliance_lateral"), atLeastZero(element, "slip_compliance_longitudinal")}};
}

}  // namespace pongsim
