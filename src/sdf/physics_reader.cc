#include "sdf/physics_reader.hh"

#include "sdf/values.hh"

namespace pongsim::sdf {

namespace {

// Seconds, so that a step is at least a nanosecond and time does not run out.
constexpr double kShortestStep = 1e-9;
constexpr double kLongestStep = 1e6;

description::PhysicsProfile readProfile(const Element& element, Context& context) {
  description::PhysicsProfile profile;
  profile.name = element.attributeOr("name", "");
  const double step = readPositive(element, "max_step_size", toSeconds(profile.maxStepSize), context);
  if (step >= kShortestStep && step <= kLongestStep) {
    profile.maxStepSize = fromSeconds(step);
  } else {
    context.diagnostics.error(element.child("max_step_size")->position,
                              "a step of " + std::string(childText(element, "max_step_size")) +
                                  " s is not between a nanosecond and a million seconds");
  }
  profile.realTimeFactor = readNotNegative(element, "real_time_factor", profile.realTimeFactor, context);
  return profile;
}

}  // namespace

description::PhysicsProfile readPhysics(const Element& world, Context& context) {
  description::PhysicsProfile chosen;
  bool isChosen = false;
  bool isChosenByMark = false;
  for (const Element& child : world.children) {
    if (child.name != "physics") continue;
    const description::PhysicsProfile profile = readProfile(child, context);
    const bool isMarked = readFlagAttribute(child, "default", false, context);
    if (!isChosen || (isMarked && !isChosenByMark)) chosen = profile;
    isChosen = true;
    isChosenByMark = isChosenByMark || isMarked;
  }
  return chosen;
}

Vector3 readGravity(const Element& world, Context& context) {
  return readVector(world, "gravity", description::World().gravity, context);
}

}  // namespace pongsim::sdf
