#include "ros2/services/run_services.hh"

#include <filesystem>
#include <system_error>
#include <utility>

#include "ros2/types/simulation_world_services.hh"

namespace pongsim::ros2 {

namespace si = simulation_interfaces;
namespace srv = simulation_interfaces::srv;

RunServices::RunServices(RosNode& node, const SystemContext& context, const ServiceNames& names, Spawner& spawner,
                         std::function<bool()> isStepped)
    : world_(context.world),
      spawner_(spawner),
      run_(context.node, names),
      isStepped_(std::move(isStepped)),
      offers_(node) {
  offers_.addAtOnce<srv::GetSimulatorFeatures>(names.ofSimulator("get_simulator_features"), [this](const auto&) {
    return srv::GetSimulatorFeatures::Response{features()};
  });
  offers_.addAtOnce<srv::GetSimulationState>(names.ofSimulator("get_simulation_state"), [this](const auto&) {
    return srv::GetSimulationState::Response{{run_.state()}, succeeded()};
  });
  offers_.add<srv::SetSimulationState>(
      names.ofSimulator("set_simulation_state"), [this](const auto& request, const auto& responder) {
        run_.setState(request.state.state, [responder](const Result& result) { responder.answer({result}); });
      });
  offers_.add<srv::StepSimulation>(
      names.ofSimulator("step_simulation"), [this](const auto& request, const auto& responder) {
        run_.step(request.steps, [responder](const Result& result) { responder.answer({result}); });
      });
  offers_.add<srv::ResetSimulation>(
      names.ofSimulator("reset_simulation"), [this](const auto& request, const auto& responder) {
        reset(request.scope, [responder](const Result& result) { responder.answer({result}); });
      });
  offers_.addAtOnce<srv::GetCurrentWorld>(names.ofSimulator("get_current_world"), [this](const auto&) {
    return srv::GetCurrentWorld::Response{succeeded(), world()};
  });
}

si::SimulatorFeatures RunServices::features() {
  using Features = si::SimulatorFeatures;
  Features features;
  features.features = {Features::kSpawning,
                       Features::kDeleting,
                       Features::kNamedPoses,
                       Features::kPoseBounds,
                       Features::kEntityTags,
                       Features::kEntityBounds,
                       Features::kEntityBoundsBox,
                       Features::kEntityBoundsConvex,
                       Features::kEntityCategories,
                       Features::kSpawningResourceString,
                       Features::kEntityStateGetting,
                       Features::kEntityStateSetting,
                       Features::kEntityInfoGetting,
                       Features::kEntityInfoSetting,
                       Features::kSpawnables,
                       Features::kSimulationReset,
                       Features::kSimulationResetSpawned,
                       Features::kSimulationStateGetting,
                       Features::kWorldInfoGetting,
                       Features::kSpawningEntities};
  if (run_.canBeAsked()) {
    for (const auto feature :
         {Features::kSimulationStateSetting, Features::kSimulationStatePause, Features::kStepSimulationSingle,
          Features::kStepSimulationMultiple, Features::kStepSimulationAction}) {
      features.features.push_back(feature);
    }
  }
  features.spawn_formats = {"sdf", "urdf"};
  features.custom_info = "pongsim; ResetSimulation takes the scopes DEFAULT, ALL and SPAWNED";
  return features;
}

si::WorldResource RunServices::world() const {
  si::WorldResource resource;
  resource.name = world_.name();
  // the name of a world loaded from text is not a file
  const auto file = world_.sourcePosition().file;
  std::error_code error;
  if (file && std::filesystem::is_regular_file(*file, error)) {
    resource.world_resource.uri = std::filesystem::absolute(*file, error).string();
  }
  return resource;
}

void RunServices::reset(std::uint8_t scope, const RunRequests::Done& done) {
  using Request = srv::ResetSimulation::Request;
  constexpr std::uint8_t kEach = Request::kScopeTime | Request::kScopeState | Request::kScopeSpawned;
  if (scope == Request::kScopeDefault || (scope & kEach) == kEach) return run_.resetAll(isStepped_(), done);
  if (scope == Request::kScopeSpawned) return spawner_.removeInserted(done);
  if ((scope & ~kEach) != 0) return done(failed("there is no scope " + std::to_string(scope)));
  done(
      refused(Result::kResultFeatureUnsupported,
              "time and state can't be reset alone; reset everything (scope 0 or 255) or delete spawned entities (4)"));
}

}  // namespace pongsim::ros2
