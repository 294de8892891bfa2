#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "web/foxglove/offer.hh"
#include "web/server/session.hh"

namespace pongsim::web::foxglove {

/// The channels reported to one client, and its subscriptions. For the server's thread.
class Channels {
 public:
  explicit Channels(std::shared_ptr<Client> client);

  /// Reports added and removed channels to the client. If several have the same topic, only the first is reported.
  void follow(std::vector<Offer> offers);

  /// Ids are those of the protocol.
  /// @return What is wrong, as a sentence without a full stop, or an empty text.
  std::string subscribe(std::uint32_t subscription, std::uint32_t channel);
  std::string unsubscribe(std::uint32_t subscription);

 private:
  struct Subscribed {
    std::uint32_t channel = 0;
    std::shared_ptr<void> open;
  };

  void end(std::map<std::uint32_t, Subscribed>::iterator subscription);

  const std::shared_ptr<Client> client_;
  bool hasTold_ = false;
  std::uint32_t nextChannel_ = 1;
  /// Keyed by id.
  std::map<std::uint32_t, Offer> channels_;
  std::map<std::uint32_t, Subscribed> subscribed_;
};

}  // namespace pongsim::web::foxglove
