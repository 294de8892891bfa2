#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "web/foxglove/topic_channels.hh"
#include "web/typed/world_scene.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// The channels with Foxglove's own message types, for its panels: the scenes and frames of the worlds,
/// "/foxglove/world/W/scene" and "/foxglove/world/W/tf", and, prefixed with "/foxglove", the topics with images, scans,
/// point clouds and positions. For the server's thread.
class TypedChannels {
 public:
  explicit TypedChannels(std::shared_ptr<Worlds> worlds);

  std::vector<Channel> all();

 private:
  std::shared_ptr<const std::string> schema(const google::protobuf::Descriptor& type);
  Channel channel(std::string topic, const google::protobuf::Descriptor& type, const void* source);
  Channel sceneChannel(const std::shared_ptr<WorldLink>& world);
  Channel framesChannel(const std::shared_ptr<WorldLink>& world);

  const std::shared_ptr<Worlds> worlds_;
  std::map<std::string, std::shared_ptr<const std::string>> schemas_;
};

}  // namespace pongsim::web::foxglove
