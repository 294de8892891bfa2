#include "sdf/unsimulated.hh"

#include <algorithm>
#include <string>
#include <string_view>

#include "sdf/values.hh"

namespace pongsim::sdf {

void warnOfSensors(const Element& element, Context& context) {
  for (const Element& child : element.children) {
    if (child.name != "sensor") continue;
    const std::string type = child.attributeOr("type", "");
    if (!context.firstTime("sensor type " + type)) continue;
    context.diagnostics.warning(child.position, "sensor type '" + type + "' is not simulated yet");
  }
}

void warnOfUnsimulated(const Element& element, Context& context) {
  constexpr std::string_view kKinds[] = {"actor", "gripper", "population"};
  for (const Element& child : element.children) {
    if (std::ranges::find(kKinds, child.name) == std::end(kKinds)) continue;
    if (!context.firstTime("kind " + child.name)) continue;
    context.diagnostics.warning(child.position, "<" + child.name + "> is not simulated yet: it is left out");
  }
}

bool refuseIncludes(const Element& element, Context& context) {
  bool found = false;
  for (const Element& child : element.children) {
    if (child.name != "include") continue;
    found = true;
    const std::string uri(childText(child, "uri"));
    context.diagnostics.error(child.position, "<include> is not supported yet",
                              "put the model" + (uri.empty() ? "" : " '" + uri + "'") + " itself in its place");
  }
  return found;
}

}  // namespace pongsim::sdf
