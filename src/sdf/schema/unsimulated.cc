#include "sdf/schema/unsimulated.hh"

#include <algorithm>
#include <string>
#include <string_view>

namespace pongsim::sdf {

void warnIfUnsimulated(const Element& element, Context& context) {
  constexpr std::string_view kKinds[] = {"gripper", "population", "model_state"};
  if (std::ranges::find(kKinds, element.name) == std::end(kKinds)) return;
  if (!context.firstTime("kind " + element.name)) return;
  context.unsimulated.warning(element.position, "<" + element.name + "> is not simulated yet: it is left out");
}

}  // namespace pongsim::sdf
