#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "web/gz/rate.hh"
#include "web/gz/settings.hh"
#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::gz {

/// What one client listens to, topics that are not there yet too. For the server's thread.
class Listening {
 public:
  /// @param settings Must outlive it.
  Listening(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds, const GzSettings& settings);

  /// Begins to listen; what the client listens to already it listens to anew.
  /// @param asPicture As PNG, of a topic with images.
  /// @return What is wrong, as a sentence without a full stop, or an empty text.
  std::string add(std::string_view topic, bool asPicture);
  void remove(std::string_view topic);
  /// Lets through so many messages of that topic a second, also where the client will listen to it later.
  /// @return As `add`.
  std::string limit(std::string_view topic, double hz);

  /// Opens what has come, closes what has gone.
  void follow();

 private:
  struct Ear {
    std::uint64_t key = 0;
    bool asPicture = false;
    /// What it listens to now: none where the topic is not there.
    std::string type;
    std::shared_ptr<WorldLink> world;
    std::shared_ptr<Rate> rate;
    std::shared_ptr<void> hearing;
  };

  std::string open(const std::string& topic, Ear& ear, const std::optional<Worlds::TopicPlace>& place);
  void end(std::string_view topic);
  Listener listenerFor(const std::string& topic, const Ear& ear) const;

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  const GzSettings& settings_;
  std::uint64_t nextKey_ = 1;
  std::map<std::string, Ear, std::less<>> ears_;
  /// By topic: of those that the client has limited.
  std::map<std::string, double, std::less<>> rates_;
};

}  // namespace pongsim::web::gz
