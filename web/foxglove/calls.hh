#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "web/foxglove/offers.hh"
#include "web/foxglove/wire.hh"
#include "web/server/session.hh"
#include "web/world/message_form.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// The services that one client is told of, and its calls. For the server's thread.
class Calls {
 public:
  /// @param offers Must outlive it.
  /// @param form In which services say what they take: Foxglove calls those only that take JSON. Calls come in both.
  Calls(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, Offers& offers, MessageForm form);

  /// Tells the client what has come and gone. One that may only look is told of services that change nothing.
  void follow();

  /// Has the service answer the client, or tells it why not.
  void call(const ServiceCall& call);

 private:
  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  Offers& offers_;
  const MessageForm form_;
  std::uint32_t nextService_ = 1;
  /// By their ids.
  std::map<std::uint32_t, Worlds::ServicePlace> services_;
};

}  // namespace pongsim::web::foxglove
