#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "web/rosbridge/cdr_json.hh"
#include "web/rosbridge/ros_topics.hh"
#include "web/server/session.hh"

namespace pongsim::web::rosbridge {

/// What one client subscribes to, including topics that do not exist yet. For the server's thread. Functions return
/// what is wrong, as a sentence without a full stop, or an empty text.
class Subscriptions {
 public:
  /// @param topics Must outlive it.
  Subscriptions(std::shared_ptr<Client> client, RosTopics& topics);

  /// @param request The client's `subscribe`; not trusted. A client may subscribe to a topic several times, with other
  /// ids: it gets each message once, at the highest rate.
  std::string add(const nlohmann::json& request);
  /// @param request The client's `unsubscribe`: of one id, or without an id of all.
  std::string remove(const nlohmann::json& request);

  /// Opens subscriptions for new topics, and closes those of removed ones.
  void follow();

 private:
  /// How messages are sent; of several subscriptions to a topic, the last of these counts.
  enum class Compression {
    kNone,
    kCbor,
    /// In CBOR with the message in CDR, as it comes from ROS.
    kCborRaw
  };
  struct Wish {
    /// Least time between messages [s].
    double interval = 0;
    /// Messages to keep; 0: as many as suit the type.
    std::size_t queue = 0;
    Compression compression = Compression::kNone;
  };
  struct Source;
  struct Opened {
    std::shared_ptr<Source> source;
    std::shared_ptr<void> subscription;
  };
  struct Wanted {
    /// Keyed by the client's ids.
    std::map<std::string, Wish> wishes;
    /// The topics of the simulation with that name, as they are now.
    std::vector<Opened> sources;
  };

  void open(const std::string& name, Wanted& wanted, std::span<const RosTopic> all);
  void close(Wanted& wanted);
  std::shared_ptr<Source> newSource(RosTopic topic, const Wanted& wanted);
  std::optional<Opened> sourceOf(const RosTopic& topic, const Wanted& wanted);
  Opened rosout(const Wanted& wanted);
  static void sendSoon(Client& client, const std::shared_ptr<Source>& source);
  static std::optional<Compression> compressionOf(std::string_view name);

  const std::shared_ptr<Client> client_;
  RosTopics& topics_;
  std::uint64_t nextKey_ = 1;
  std::map<std::string, Wanted, std::less<>> subscriptions_;
};

}  // namespace pongsim::web::rosbridge
