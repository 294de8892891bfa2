#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "web/foxglove/calls.hh"
#include "web/foxglove/channels.hh"
#include "web/foxglove/graph.hh"
#include "web/foxglove/log_offer.hh"
#include "web/foxglove/offers.hh"
#include "web/foxglove/parameters.hh"
#include "web/foxglove/publications.hh"
#include "web/foxglove/typed_offers.hh"
#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// A client that speaks Foxglove's protocol.
class FoxgloveSession final : public Session {
 public:
  /// @param offers, own, typed, log, assets Must outlive it. `own` is null except for our own page, for which `typed`
  /// is null.
  FoxgloveSession(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, Offers& offers,
                  const OwnChannels* own, TypedOffers* typed, LogOffer& log, const AssetSource& assets);

  void text(std::string_view message) override;
  void binary(std::span<const std::byte> message) override;

 private:
  /// What is reported about the worlds. A separate object, so that data queued for the socket can detect that the
  /// session has ended.
  struct Told {
    Channels channels;
    Calls calls;
    Graph graph;
    Offers& offers;
    const OwnChannels* own;
    TypedOffers* typed;
    LogOffer& log;

    void follow();
  };

  void sendServerInfo();
  /// Calls a function with each element of a list; it returns what is wrong with the element, or an empty text.
  void each(const nlohmann::json& message, const char* list,
            const std::function<std::string(const nlohmann::json&)>& deal);
  std::string subscribe(const nlohmann::json& subscription);
  void fetchAsset(const nlohmann::json& message);
  void complain(std::string_view what);

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  const AssetSource& assets_;
  const std::shared_ptr<Told> told_;
  Publications publications_;
  const std::shared_ptr<Parameters> parameters_;
  std::shared_ptr<void> watch_;
  std::shared_ptr<Callee> timeTeller_;
  std::shared_ptr<void> regularly_;
};

}  // namespace pongsim::web::foxglove
