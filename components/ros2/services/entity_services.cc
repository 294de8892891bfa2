#include "ros2/services/entity_services.hh"

#include <algorithm>
#include <memory>
#include <utility>

#include "ros2/services/bounds.hh"
#include "ros2/services/named_poses.hh"
#include "ros2/services/spawnables.hh"
#include "ros2/types/simulation_entity_services.hh"

namespace pongsim::ros2 {

namespace si = simulation_interfaces;
namespace srv = simulation_interfaces::srv;

EntityServices::EntityServices(RosNode& node, const SystemContext& context, const ServiceNames& names,
                               const Frames& frames)
    : edits_(context.edits), finder_(context.world, frames), spawner_(finder_, context.edits), offers_(node) {
  offerSpawning(names);
  offerEntities(names);
  offerStates(names);
  offerPlaces(names);
}

void EntityServices::worldReset() {
  infos_.forget();
  accelerations_.forget();
  spawner_.forget();
}

void EntityServices::offerSpawning(const ServiceNames& names) {
  offers_.add<srv::SpawnEntity>(names.ofSimulator("spawn_entity"), [this](const auto& request, const auto& responder) {
    spawner_.spawn(
        {request.name, request.allow_renaming, request.entity_resource, request.entity_namespace, request.initial_pose},
        [responder](const si::SpawnResult& result) {
          responder.answer({result.result, result.entity_name});
        });
  });
  offers_.add<srv::SpawnEntities>(names.ofSimulator("spawn_entities"),
                                  [this](const auto& request, const auto& responder) { spawnAll(request, responder); });
  offers_.add<srv::DeleteEntity>(
      names.ofSimulator("delete_entity"), [this](const auto& request, const auto& responder) {
        spawner_.remove(request.entity, [responder](const Result& result) { responder.answer({result}); });
      });
  offers_.addAtOnce<srv::GetSpawnables>(names.ofSimulator("get_spawnables"), [this](const auto& request) {
    return spawnables(edits_.resourceFolders(), request.sources,
                      [this](const std::string& address) { return edits_.resolve(address); });
  });
}

/// Each independently: a failure does not prevent the others.
void EntityServices::spawnAll(const srv::SpawnEntities::Request& request,
                              const Responder<srv::SpawnEntities>& responder) {
  using Response = srv::SpawnEntities::Response;
  struct Progress {
    std::size_t left;
    Response response;
  };
  const std::size_t count = request.spawn_requests.size();
  if (count == 0) return responder.answer({succeeded(), {}});
  const auto progress = std::make_shared<Progress>(Progress{count, {succeeded(), {}}});
  progress->response.results.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    spawner_.spawn(request.spawn_requests[i], [progress, responder, i](const si::SpawnResult& result) {
      Response& response = progress->response;
      response.results[i] = result;
      if (!isOk(result.result)) {
        response.result =
            refused(Response::kEntitiesSpawnFailed, "at least one entity was not spawned: see the results");
      }
      if (--progress->left == 0) responder.answer(response);
    });
  }
}

std::optional<std::vector<Model>> EntityServices::filtered(const si::EntityFilters& filters, Result& result) const {
  const std::optional<EntityFilter> filter = EntityFilter::from(filters, result);
  if (!filter) return std::nullopt;
  std::vector<Model> models = finder_.entities();
  std::erase_if(models, [&](const Model& model) { return !filter->takes(finder_.world(), model, infos_); });
  return models;
}

void EntityServices::offerEntities(const ServiceNames& names) {
  offers_.addAtOnce<srv::GetEntities>(names.ofSimulator("get_entities"), [this](const auto& request) {
    srv::GetEntities::Response response{succeeded(), {}};
    const auto models = filtered(request.filters, response.result);
    if (!models) return response;
    for (const Model& model : *models) response.entities.push_back(model.scopedName());
    return response;
  });
  offers_.addAtOnce<srv::GetEntityInfo>(names.ofSimulator("get_entity_info"), [this](const auto& request) {
    Outcome<Model> model = finder_.find(request.entity);
    if (!model) return srv::GetEntityInfo::Response{notFound(model.error), {}};
    return srv::GetEntityInfo::Response{succeeded(), infos_.of(finder_.world(), *model)};
  });
  offers_.addAtOnce<srv::SetEntityInfo>(names.ofSimulator("set_entity_info"), [this](const auto& request) {
    Outcome<Model> model = finder_.find(request.entity);
    return srv::SetEntityInfo::Response{model ? infos_.set(*model, request.info) : notFound(model.error)};
  });
  offers_.addAtOnce<srv::GetEntityBounds>(names.ofSimulator("get_entity_bounds"), [this](const auto& request) {
    Outcome<Model> model = finder_.find(request.entity);
    if (!model) return srv::GetEntityBounds::Response{notFound(model.error), {}};
    Outcome<si::Bounds> bounds = boundsOf(*model);
    if (!bounds) return srv::GetEntityBounds::Response{failed(bounds.error), {}};
    return srv::GetEntityBounds::Response{succeeded(), *bounds};
  });
}

void EntityServices::offerStates(const ServiceNames& names) {
  offers_.addAtOnce<srv::GetEntityState>(names.ofSimulator("get_entity_state"), [this](const auto& request) {
    Outcome<Model> model = finder_.find(request.entity);
    if (!model) return srv::GetEntityState::Response{notFound(model.error), {}};
    return srv::GetEntityState::Response{succeeded(), stateOf(*model, now_, accelerations_)};
  });
  offers_.addAtOnce<srv::GetEntitiesStates>(names.ofSimulator("get_entities_states"), [this](const auto& request) {
    srv::GetEntitiesStates::Response response{succeeded(), {}, {}};
    const auto models = filtered(request.filters, response.result);
    if (!models) return response;
    for (const Model& model : *models) {
      response.entities.push_back(model.scopedName());
      response.states.push_back(stateOf(model, now_, accelerations_));
    }
    return response;
  });
  offers_.addAtOnce<srv::SetEntityState>(names.ofSimulator("set_entity_state"), [this](const auto& request) {
    return srv::SetEntityState::Response{setState(finder_, request)};
  });
}

void EntityServices::offerPlaces(const ServiceNames& names) {
  offers_.addAtOnce<srv::GetNamedPoses>(names.ofSimulator("get_named_poses"),
                                        [this](const auto& request) { return namedPoses(finder_, request.tags); });
  offers_.addAtOnce<srv::GetNamedPoseBounds>(names.ofSimulator("get_named_pose_bounds"), [this](const auto& request) {
    return namedPoseBounds(finder_, request.name);
  });
}

}  // namespace pongsim::ros2
