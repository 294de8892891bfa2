#include "web/world/read_only_service.hh"

#include <algorithm>

namespace pongsim::web {

namespace {

constexpr std::string_view kOfTheServer[] = {"/gazebo/worlds", "/gazebo/resource_paths/get", "/marker/list"};
constexpr std::string_view kOfAWorld[] = {"/scene/info", "/scene/graph",       "/state",
                                          "/gui/info",   "/particle_emitters", "/generate_world_sdf"};
constexpr std::string_view kWorld = "/world/";

}  // namespace

bool isReadOnlyService(std::string_view service) {
  if (std::ranges::find(kOfTheServer, service) != std::end(kOfTheServer)) return true;
  if (!service.starts_with(kWorld)) return false;
  service.remove_prefix(kWorld.size());
  const std::size_t slash = service.find('/');
  if (slash == 0 || slash == std::string_view::npos) return false;
  return std::ranges::find(kOfAWorld, service.substr(slash)) != std::end(kOfAWorld);
}

}  // namespace pongsim::web
