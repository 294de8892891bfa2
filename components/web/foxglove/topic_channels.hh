#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "web/foxglove/channel.hh"
#include "web/world/worlds.hh"

namespace google::protobuf {
class Descriptor;
}

namespace pongsim::web::foxglove {

/// The channels with the messages of the worlds' topics, as they are. For the server's thread.
class TopicChannels {
 public:
  explicit TopicChannels(std::shared_ptr<Worlds> worlds);

  /// @return The current topics of all worlds, sorted by name.
  std::vector<Channel> all();

  /// @return The schema of a message type in base64, shared by all callers.
  std::shared_ptr<const std::string> schema(const std::string& type);
  /// @return Its JSON schema, as text.
  std::shared_ptr<const std::string> jsonSchema(const std::string& type);

 private:
  const std::shared_ptr<Worlds> worlds_;
  using Schemas = std::map<std::string, std::shared_ptr<const std::string>, std::less<>>;
  Schemas schemas_;
  Schemas jsonSchemas_;
};

}  // namespace pongsim::web::foxglove
