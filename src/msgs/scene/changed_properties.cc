#include "msgs/scene/changed_properties.hh"

namespace pongsim::msgs {

std::optional<description::Material> materialNow(const description::Visual& visual, VisualId id,
                                                 const ChangedProperties& changed) {
  const auto found = changed.colors.find(id);
  if (found == changed.colors.end()) return visual.material;
  description::Material material = visual.material.value_or(description::Material());
  const Eigen::Vector3f color = found->second.color.cast<float>();
  // as cameras see it
  for (description::Color* each : {&material.diffuse, &material.ambient}) {
    *each = {color.x(), color.y(), color.z(), each->alpha};
  }
  if (found->second.glows) material.emissive = {color.x(), color.y(), color.z(), material.emissive.alpha};
  return material;
}

}  // namespace pongsim::msgs
