#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "web/foxglove/offers.hh"
#include "web/typed/world_scene.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// The channels with Foxglove's own message types, for its panels: the scenes and frames of the worlds,
/// "/foxglove/world/W/scene" and "/foxglove/world/W/tf", and, prefixed with "/foxglove", the topics with images, scans,
/// point clouds and positions. For the server's thread.
class TypedOffers {
 public:
  explicit TypedOffers(std::shared_ptr<Worlds> worlds);

  std::vector<Offer> all();

 private:
  std::shared_ptr<const std::string> schema(const google::protobuf::Descriptor& type);
  Offer offer(std::string topic, const google::protobuf::Descriptor& type, const void* source);
  Offer sceneOffer(const std::shared_ptr<WorldLink>& world);
  Offer framesOffer(const std::shared_ptr<WorldLink>& world);

  const std::shared_ptr<Worlds> worlds_;
  std::map<std::string, std::shared_ptr<const std::string>> schemas_;
};

}  // namespace pongsim::web::foxglove
