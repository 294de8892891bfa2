#include "sdf/unsimulated.hh"

#include <algorithm>
#include <string>
#include <string_view>

namespace pongsim::sdf {

void warnOfSensors(const Element& element, Context& context) {
  for (const Element& child : element.children) {
    if (child.name != "sensor") continue;
    const std::string type = child.attributeOr("type", "");
    if (!context.firstTime("sensor type " + type)) continue;
    context.unsimulated.warning(child.position, "sensor type '" + type + "' is not simulated yet");
  }
}

void warnIfUnsimulated(const Element& element, Context& context) {
  constexpr std::string_view kKinds[] = {"actor", "gripper", "population"};
  if (std::ranges::find(kKinds, element.name) == std::end(kKinds)) return;
  if (!context.firstTime("kind " + element.name)) return;
  context.unsimulated.warning(element.position, "<" + element.name + "> is not simulated yet: it is left out");
}

}  // namespace pongsim::sdf
