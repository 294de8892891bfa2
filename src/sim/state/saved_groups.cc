#include "sim/state/saved_groups.hh"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "sim/edits/editor.hh"

namespace pongsim::sim {

void SavedGroup::transfer(StateArchive& archive) {
  for (std::vector<std::string>* names : {&models, &lights, &actors}) archive(*names);
}

std::vector<SavedGroup> listGroups(const Access& access) {
  std::vector<SavedGroup> groups;
  for (const Shelved& shelved : access.shelf) {
    SavedGroup& group = groups.emplace_back();
    for (const world::ModelRecord& model : shelved.entities.models) {
      if (model.parent == world::kNoSlot) group.models.push_back(model.scopedName);
    }
    for (const world::LightRecord& light : shelved.entities.lights) {
      if (light.link == world::kNoSlot) group.lights.push_back(light.description->name);
    }
    for (const world::ActorRecord& actor : shelved.entities.actors) group.actors.push_back(actor.description->name);
  }
  return groups;
}

void bringAllBack(Access& access) {
  std::vector<std::size_t> places(access.shelf.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  Editor(access).bringBack(places);
}

void setAside(const std::vector<SavedGroup>& groups, Access& access) {
  const world::Entities& entities = access.entities;
  std::vector<world::Roots> roots;
  // a light may have been removed since
  const auto add = [](world::Slot slot, std::vector<world::Slot>& slots) {
    if (slot != world::kNoSlot) slots.push_back(slot);
  };
  for (const SavedGroup& group : groups) {
    world::Roots& found = roots.emplace_back();
    for (const std::string& name : group.models) add(entities.findModel(name), found.models);
    for (const std::string& name : group.lights) add(entities.findLight(world::kNoSlot, name), found.lights);
    for (const std::string& name : group.actors) {
      const auto isIt = [&name](const world::ActorRecord& actor) { return actor.description->name == name; };
      const auto actor = std::ranges::find_if(entities.actors(), isIt);
      found.actors.push_back(static_cast<world::Slot>(actor - entities.actors().begin()));
    }
  }
  Editor(access).setAside(roots);
}

}  // namespace pongsim::sim
