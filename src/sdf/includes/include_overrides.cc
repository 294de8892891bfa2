#include "sdf/includes/include_overrides.hh"

#include "base/element_edit.hh"

namespace pongsim::sdf {

namespace {

/// Replaces the first child with the same name, the only one that counts; appends it if there is none.
void replaceChild(Element& element, const Element& source) {
  base::childOrNew(element, source.name, source.position) = source;
}

}  // namespace

void applyOverrides(const Element& include, Element& included, Context& context) {
  const bool isModel = included.name == "model";
  for (const Element& child : include.children) {
    const bool isForModels = child.name == "static" || child.name == "placement_frame" || child.name == "plugin";
    if (isForModels && !isModel) {
      context.diagnostics.warning(child.position, "<" + child.name + "> has no effect: the included element is <" +
                                                      included.name + ">, not <model>");
    } else if (child.name == "name" && !child.text.empty()) {
      base::setAttribute(included, "name", child.text, child.position);
    } else if (child.name == "pose" || child.name == "static") {
      replaceChild(included, child);
    } else if (child.name == "plugin") {
      included.children.push_back(child);
    } else if (child.name == "placement_frame") {
      base::setAttribute(included, "placement_frame", child.text, child.position);
      // without this, the model's own pose would place another frame
      if (include.child("pose") == nullptr) {
        context.diagnostics.error(child.position, "<include> has a <placement_frame> but no <pose>",
                                  "the pose is that of the placement frame");
      }
    }
  }
}

void joinOverrides(const Element& outer, Element& inner) {
  for (const Element& child : outer.children) {
    if (child.name == "plugin") {
      inner.children.push_back(child);
    } else if (child.name != "uri") {
      replaceChild(inner, child);
    }
  }
}

}  // namespace pongsim::sdf
