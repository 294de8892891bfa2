#include "urdf/collision_names.hh"

#include <algorithm>
#include <utility>

namespace pongsim::urdf {

void CollisionNames::add(std::string ownLink, std::string inFile, std::string converted) {
  collisions_.push_back({std::move(ownLink), std::move(inFile), std::move(converted)});
}

void CollisionNames::replaceIn(Element& sensor, const std::string& ownLink) const {
  const auto contact = std::ranges::find(sensor.children, "contact", &Element::name);
  if (contact == sensor.children.end()) return;
  for (Element& name : contact->children) {
    if (name.name != "collision") continue;
    if (std::ranges::find(collisions_, name.text, &Collision::converted) != collisions_.end()) continue;
    const auto isMeant = [&](const Collision& each) { return each.ownLink == ownLink && each.inFile == name.text; };
    const auto found = std::ranges::find_if(collisions_, isMeant);
    if (found != collisions_.end() && std::ranges::count_if(collisions_, isMeant) == 1) name.text = found->converted;
  }
}

}  // namespace pongsim::urdf
