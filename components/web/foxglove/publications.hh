#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "web/server/session.hh"
#include "web/world/message_form.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// What one client publishes. For the server's thread. Functions return what is wrong, as a sentence without a full
/// stop, or an empty text.
class Publications {
 public:
  Publications(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds);

  /// @param channel From the client's `advertise`; not trusted.
  std::string open(const nlohmann::json& channel);
  std::string close(std::uint32_t channel);
  std::string publish(std::uint32_t channel, std::span<const std::byte> message);

 private:
  struct Publication {
    std::string type;
    MessageForm form = MessageForm::kProtobuf;
    std::shared_ptr<RemotePublisher> publisher;
  };

  std::string fault(const nlohmann::json& channel);
  std::shared_ptr<WorldLink> worldFor(const std::string& topic) const;

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  /// Keyed by the client's channel id.
  std::map<std::uint32_t, Publication> publications_;
  std::size_t unknownTypes_ = 0;
};

}  // namespace pongsim::web::foxglove
