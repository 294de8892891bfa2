#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "web/server/session.hh"
#include "web/world/worlds.hh"

namespace pongsim::web::foxglove {

/// The parameters that one client reads, sets and subscribes to: for each world "/world/W/paused", "real_time_factor",
/// "max_step_size" and "gravity". For the server's thread.
class Parameters final : public Callee, public std::enable_shared_from_this<Parameters> {
 public:
  Parameters(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds);

  // Handlers for untrusted messages of clients. They return what is wrong, as a sentence without a full stop, or an
  // empty text.

  /// Sends the named parameters, or all.
  std::string get(const nlohmann::json& message);
  /// Makes the worlds set them. Reports refused ones to the client; with an "id", sends back those that were accepted.
  std::string set(const nlohmann::json& message);
  /// Sends the named parameters, or all, whenever they change.
  std::string subscribe(const nlohmann::json& message);
  std::string unsubscribe(const nlohmann::json& message);

  /// Sends changes.
  void called() override;

 private:
  using Values = std::map<std::string, nlohmann::json>;
  /// A `setParameters` that has not been fully answered.
  struct Setting;

  Values values() const;
  std::string setOne(const nlohmann::json& parameter, const std::shared_ptr<Setting>& setting);
  void send(const Values& values, const std::optional<std::string>& id);

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  /// Subscribed parameters, unless all are.
  std::set<std::string> wanted_;
  bool wantsAll_ = false;
  /// The values at the last call, or when the subscription began.
  Values sent_;
  std::shared_ptr<void> regularly_;
};

}  // namespace pongsim::web::foxglove
