#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace pongsim::web {

/// What a client has been sent, by topic. For any thread.
class ClientTraffic {
 public:
  struct Count {
    std::uint64_t messages = 0;
    std::uint64_t bytes = 0;
    bool operator==(const Count&) const = default;
  };

  /// @param number Tells it from other clients.
  /// @param protocol The subprotocol that it asked for.
  ClientTraffic(std::uint64_t number, std::string address, std::string protocol);

  std::uint64_t number() const { return number_; }
  const std::string& address() const { return address_; }
  const std::string& protocol() const { return protocol_; }

  /// Counts what is sent under a key (`Client::sendData`) for a topic, until another topic has the key. Of very many
  /// topics of one client, the later ones are counted together.
  void name(std::uint64_t key, const std::string& topic);
  /// @param key Nothing: what belongs to no topic, such as lists and replies.
  void add(std::optional<std::uint64_t> key, std::size_t bytes);

  /// @return The counts of all topics so far; those of what belongs to none under "".
  std::map<std::string, Count> counts() const;

 private:
  const std::uint64_t number_;
  const std::string address_;
  const std::string protocol_;
  mutable std::mutex mutex_;
  std::map<std::string, Count> byTopic_;
  /// Into `byTopic_`, whose entries stay where they are.
  std::unordered_map<std::uint64_t, Count*> byKey_;
};

/// The traffic of all clients of a server. For any thread.
class TrafficBook {
 public:
  /// @return That of a new client, which is listed as long as it exists.
  std::shared_ptr<ClientTraffic> add(std::string address, std::string protocol);
  std::vector<std::shared_ptr<const ClientTraffic>> all() const;

 private:
  mutable std::mutex mutex_;
  std::uint64_t next_ = 1;
  std::vector<std::weak_ptr<const ClientTraffic>> clients_;
};

}  // namespace pongsim::web
