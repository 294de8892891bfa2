#include "sdf/light_reader.hh"

#include <optional>
#include <utility>

#include "sdf/names.hh"

namespace pongsim::sdf {

LightDraft readLight(const Element& element, const std::string& owner, Context& context) {
  LightDraft draft;
  draft.light.name = readName(element, owner, context);
  draft.light.type = element.attributeOr("type", "point");
  draft.light.position = element.position;
  draft.pose = readPose(element, context);
  return draft;
}

description::Light finishLight(LightDraft&& draft, const Scope& scope, Context& context) {
  description::Light light = std::move(draft.light);
  light.X_WorldLight = draft.pose.value;
  if (!draft.pose.relativeTo.empty()) {
    const std::optional<Scope::Found> frame = scope.findOrComplain(
        draft.pose.relativeTo, "the pose of light '" + light.name + "' is relative to", draft.pose.position, context);
    if (frame) light.X_WorldLight = frame->X_ScopeFrame * draft.pose.value;
  }
  return light;
}

}  // namespace pongsim::sdf
