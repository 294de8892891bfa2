#include "msgs/scene/changed_properties.hh"

namespace pongsim::msgs {

std::optional<description::Material> materialNow(const description::Visual& visual, VisualId id,
                                                 const ChangedProperties& changed) {
  const auto found = changed.colors.find(id);
  if (found == changed.colors.end()) return visual.material;
  description::Material material = visual.material.value_or(description::Material());
  const VisualColors& colors = found->second;
  const auto set = [](const std::optional<Vector3>& color, description::Color& to) {
    if (!color) return;
    const Eigen::Vector3f told = color->cast<float>();
    to = {told.x(), told.y(), told.z(), to.alpha};
  };
  set(colors.diffuse, material.diffuse);
  // as cameras see it
  set(colors.ambient ? colors.ambient : colors.diffuse, material.ambient);
  set(colors.specular, material.specular);
  set(colors.emissive, material.emissive);
  return material;
}

}  // namespace pongsim::msgs
