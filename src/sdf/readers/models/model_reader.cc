#include "sdf/readers/models/model_reader.hh"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/nearest_word.hh"
#include "sdf/includes/includes.hh"
#include "sdf/readers/models/emitter_reader.hh"
#include "sdf/readers/models/parts_reader.hh"
#include "sdf/readers/models/semantics_reader.hh"
#include "sdf/readers/shapes/data_systems.hh"
#include "sdf/text/names.hh"

namespace pongsim::sdf {

namespace {

void readCanonicalLink(const Element& element, Scope& scope, Context& context) {
  const Element::Attribute* attribute = element.attribute("canonical_link");
  if (attribute == nullptr || attribute->value.empty()) return;
  const std::optional<Scope::ResolvedFrame> found =
      scope.findOrComplain(attribute->value, scope.label() + " has the canonical link", attribute->position, context);
  if (!found) return;
  if (found->kind == FrameKind::kLink) {
    scope.setCanonicalLink(attribute->value);
  } else {
    context.diagnostics.error(attribute->position,
                              "the canonical link of " + scope.label() + ", '" + attribute->value + "', is not a link");
  }
}

/// If the link of a friction direction does not exist, warns and uses the collision's frame.
void checkFrictionFrames(description::Model& model, const std::string& label, Context& context) {
  std::vector<std::string_view> names;
  for (const description::Link& link : model.links) names.push_back(link.name);
  for (description::Link& link : model.links) {
    for (description::Collision& collision : link.collisions) {
      std::string& frame = collision.surface.fdir1Link;
      if (frame.empty() || std::ranges::find(names, frame) != names.end()) continue;
      context.diagnostics.warning(collision.position,
                                  "the <fdir1> of collision '" + collision.name + "' is expressed in '" + frame +
                                      "', which is not a link of " + label + ": the collision's frame is used",
                                  base::didYouMean(frame, names));
      frame.clear();
    }
  }
}

bool hasChild(const Element& element, std::string_view name) { return element.child(name) != nullptr; }

}  // namespace

ModelDraft readModel(const Element& element, const std::string& owner, bool isInStatic, Context& context) {
  ModelDraft draft;
  description::Model& model = draft.model;
  if (!context.includes.enterModel(element.position)) return draft;
  model.name = readName(element, owner, context);
  model.position = element.position;
  // the source is that of the file's own model, not of a nested one
  model.urdf = {std::exchange(context.urdf, nullptr)};
  model.isStatic = readFlag(element, "static", false, context);
  model.selfCollide = readFlag(element, "self_collide", false, context);
  model.isInWind = readFlag(element, "enable_wind", false, context);
  draft.pose = readPose(element, context);
  draft.placementFrame = element.attributeOr("placement_frame", "");

  const std::string label = model.name.empty() ? "a model" : "model '" + model.name + "'";
  draft.scope = std::make_unique<Scope>(std::string(kModelFrame), label);
  if (model.isStatic) draft.scope->setStatic();
  PartsReader parts(*draft.scope, model.isStatic || isInStatic, context);
  parts.read(element);
  context.includes.leaveModel();
  if (!model.isStatic && !hasChild(element, "link") && !hasChild(element, "model") && !hasChild(element, "include")) {
    context.diagnostics.error(element.position, label + " has no link", "a model that is not static needs a <link>");
  }

  readCanonicalLink(element, *draft.scope, context);
  draft.scope->resolve(context);
  model.canonicalLink = draft.scope->link(0);
  model.links = parts.takeLinks();
  checkFrictionFrames(model, label, context);
  model.joints = parts.takeJoints();
  model.frames = parts.takeFrames();
  model.models = parts.takeModels();
  model.plugins = parts.takePlugins();
  addSystemEmitters(model, label, context);
  model.label = readLabel(model.plugins, label, context);
  model.semantics = readSemantics(element, label, context);
  context.urdf = model.urdf.source;
  return draft;
}

}  // namespace pongsim::sdf
