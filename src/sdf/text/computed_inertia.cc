#include "sdf/text/computed_inertia.hh"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/element_edit.hh"
#include "sdf/text/values.hh"

namespace pongsim::sdf {

namespace {

template <class Named>
const Named* withName(const std::vector<Named>& all, const Element& element) {
  const auto found = std::ranges::find(all, element.attributeOr("name", ""), &Named::name);
  return found == all.end() ? nullptr : &*found;
}

void write(Element& inertial, const description::Inertial& computed) {
  const SourcePosition& position = inertial.position;
  const auto set = [&position](Element& parent, std::string_view name, double value) {
    base::setChild(parent, name, position, base::shortestText(value));
  };
  const Vector3 centre = computed.X_LinkCom.position;
  std::string pose;
  for (const double value : centre) pose += base::shortestText(value) + " ";
  // a pose as it was could have an attribute about its rotation or frame
  std::erase_if(inertial.children, [](const Element& child) { return child.name == "pose"; });
  base::setChild(inertial, "pose", position, pose + "0 0 0");
  set(inertial, "mass", computed.mass);
  const Matrix3 rotation = computed.X_LinkCom.rotation.toRotationMatrix();
  const Matrix3 moments = rotation * computed.moments * rotation.transpose();
  Element& inertia = base::childOrNew(inertial, "inertia", position);
  constexpr std::pair<std::string_view, std::pair<int, int>> kMoments[] = {
      {"ixx", {0, 0}}, {"ixy", {0, 1}}, {"ixz", {0, 2}}, {"iyy", {1, 1}}, {"iyz", {1, 2}}, {"izz", {2, 2}}};
  for (const auto& [name, place] : kMoments) set(inertia, name, moments(place.first, place.second));
}

void write(Element& parent, const std::vector<description::Model>& models) {
  for (Element& child : parent.children) {
    const description::Model* const model = child.name == "model" ? withName(models, child) : nullptr;
    if (model == nullptr) continue;
    for (Element& part : child.children) {
      const description::Link* const link = part.name == "link" ? withName(model->links, part) : nullptr;
      Element* const inertial = link == nullptr ? nullptr : base::childOf(part, "inertial");
      if (inertial != nullptr && parseFlag(inertial->attributeOr("auto", "false")).value_or(false)) {
        write(*inertial, link->inertial);
      }
    }
    write(child, model->models);
  }
}

}  // namespace

void writeComputedInertia(Element& root, const Root& loaded) {
  write(root, loaded.models);
  for (Element& child : root.children) {
    const description::World* const world = child.name == "world" ? withName(loaded.worlds, child) : nullptr;
    if (world != nullptr) write(child, world->models);
  }
}

}  // namespace pongsim::sdf
