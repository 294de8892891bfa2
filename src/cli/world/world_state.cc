#include "cli/world/world_state.hh"

#include "pongsim/node.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

MessagePointer askForState(Transport& transport, const std::string& world, std::chrono::nanoseconds timeout,
                           bool hasAnswered) {
  const MessagePointer request = newMessage("ignition.msgs.Empty");
  MessagePointer reply = newMessage("ignition.msgs.SerializedStepMap");
  const CallResult result = transport.node().call("/world/" + world + "/state", *request, *reply, timeout);
  if (result) return reply;
  const bool isGone = result.outcome == CallOutcome::kGone;
  if (isGone || (result.outcome == CallOutcome::kNoService && hasAnswered)) {
    fail("world '" + world + "' has ended");
  } else if (result.outcome == CallOutcome::kNoService) {
    fail("world '" + world + "' does not offer its state",
         "add <plugin filename=\"ignition-gazebo-scene-broadcaster-system\" "
         "name=\"ignition::gazebo::systems::SceneBroadcaster\"/>");
  } else {
    fail(result.error);
  }
  return nullptr;
}

}  // namespace pongsim::cli
