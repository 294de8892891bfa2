#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "web/foxglove/channel.hh"
#include "web/server/session.hh"

namespace pongsim::web::foxglove {

/// The channels advertised to one client, and its subscriptions. For the server's thread.
class Subscriptions {
 public:
  explicit Subscriptions(std::shared_ptr<Client> client);

  /// Advertises added channels to the client, and removes the others. Of several with the same topic, the first is
  /// advertised.
  void follow(std::vector<Channel> channels);

  /// Ids are those of the protocol.
  /// @return What is wrong, as a sentence without a full stop, or an empty text.
  std::string subscribe(std::uint32_t subscription, std::uint32_t channel);
  std::string unsubscribe(std::uint32_t subscription);
  /// Passes on what the client wants of a subscription (`OwnChannel::ask`).
  std::string ask(std::uint32_t subscription, const nlohmann::json& wish);

 private:
  struct Subscription {
    std::uint32_t channel = 0;
    std::shared_ptr<void> open;
  };

  void end(std::map<std::uint32_t, Subscription>::iterator subscription);

  const std::shared_ptr<Client> client_;
  bool hasAdvertised_ = false;
  std::uint32_t nextChannel_ = 1;
  /// Keyed by id.
  std::map<std::uint32_t, Channel> channels_;
  std::map<std::uint32_t, Subscription> subscriptions_;
};

}  // namespace pongsim::web::foxglove
