#include "physics/contacts/friction_frames.hh"

#include <algorithm>
#include <string>

#include "physics/convert.hh"

namespace pongsim::physics {

void FrictionFrames::find(std::span<const base::Arena::Pointer<Body>> bodies, world::Slot first,
                          const world::Entities& entities) {
  for (const auto& body : bodies.subspan(first)) {
    if (entities.links()[body->link()].isSetAside) continue;
    LinkShape& shape = body->shape();
    for (std::size_t i = 0; i < shape.partCount(); ++i) {
      const std::string& name = shape.part(i).surface->fdir1Link;
      if (name.empty()) continue;
      const world::Slot model = entities.links()[body->link()].model;
      const auto& links = entities.models()[model].links;
      const auto frame = std::ranges::find_if(
          links, [&](world::Slot link) { return entities.links()[link].description->name == name; });
      if (frame != links.end()) frames_.push_back({&shape.part(i), body.get(), bodies[*frame].get()});
    }
  }
}

void FrictionFrames::remove(const std::vector<world::Slot>& links) {
  std::erase_if(frames_, [&links](const Frame& each) { return std::ranges::binary_search(links, each.body->link()); });
}

void FrictionFrames::turn() {
  for (const Frame& each : frames_) {
    const Pose X_BodyLink = each.frame->X_LinkBody().inverse();
    const btVector3 direction = each.frame->rigid().getWorldTransform().getBasis() *
                                toBullet(Vector3(X_BodyLink.rotation * each.part->surface->fdir1));
    each.part->fdir1_World = fromBullet(direction);
  }
}

}  // namespace pongsim::physics
