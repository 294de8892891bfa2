#include "sdf/includes/include_overrides.hh"

#include <algorithm>

namespace pongsim::sdf {

namespace {

void setAttribute(Element& element, std::string_view name, const Element& source) {
  const auto attribute = std::ranges::find(element.attributes, name, &Element::Attribute::name);
  if (attribute != element.attributes.end()) {
    attribute->value = source.text;
    attribute->position = source.position;
  } else {
    element.attributes.push_back({std::string(name), source.text, source.position});
  }
}

/// Replaces the first child with the same name, the only one that counts; appends it if there is none.
void setChild(Element& element, const Element& source) {
  const auto found = std::ranges::find(element.children, source.name, &Element::name);
  if (found != element.children.end()) {
    *found = source;
  } else {
    element.children.push_back(source);
  }
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
      setAttribute(included, "name", child);
    } else if (child.name == "pose" || child.name == "static") {
      setChild(included, child);
    } else if (child.name == "plugin") {
      included.children.push_back(child);
    } else if (child.name == "placement_frame") {
      setAttribute(included, "placement_frame", child);
      // without this, the model's own pose would place another frame
      if (include.child("pose") == nullptr) {
        context.diagnostics.error(child.position, "<include> has a <placement_frame> but no <pose>",
                                  "the pose is that of the placement frame");
      }
    }
  }
}

}  // namespace pongsim::sdf
