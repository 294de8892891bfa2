#include "description/actor.hh"

namespace pongsim::description {

std::vector<Visual> visualsOf(const Actor& actor) {
  std::vector<Visual> visuals;
  if (!actor.skin.uri.empty()) {
    Mesh mesh;
    mesh.uri = actor.skin.uri;
    mesh.file = actor.skin.file;
    mesh.scale = Vector3::Constant(actor.skin.scale);
    Visual& skin = visuals.emplace_back();
    skin.name = "skin";
    skin.position = actor.position;
    skin.geometry = mesh;
  }
  visuals.insert(visuals.end(), actor.visuals.begin(), actor.visuals.end());
  return visuals;
}

}  // namespace pongsim::description
