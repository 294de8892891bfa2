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

/// The parameters that one client reads, sets and is told of: of each world "/world/W/paused", "real_time_factor",
/// "max_step_size" and "gravity". For the server's thread.
class Parameters final : public Callee, public std::enable_shared_from_this<Parameters> {
 public:
  Parameters(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds);

  // What clients say, which may be anything. They return what is wrong, as a sentence without a full stop, or an empty
  // text.

  /// Tells those that are named, or all.
  std::string get(const nlohmann::json& message);
  /// Has the worlds set them. What they refuse the client is told; with an "id" it is told those that they took.
  std::string set(const nlohmann::json& message);
  /// Tells those that are named, or all, whenever they change.
  std::string subscribe(const nlohmann::json& message);
  std::string unsubscribe(const nlohmann::json& message);

  /// Tells what has changed.
  void called() override;

 private:
  using Values = std::map<std::string, nlohmann::json>;
  /// A `setParameters` of which not all has been answered.
  struct Setting;

  Values values() const;
  std::string setOne(const nlohmann::json& parameter, const std::shared_ptr<Setting>& setting);
  void tell(const Values& values, const std::optional<std::string>& id);

  const std::shared_ptr<Client> client_;
  const std::shared_ptr<Worlds> worlds_;
  /// Those that it wants to hear of; all of them if that is so.
  std::set<std::string> wanted_;
  bool wantsAll_ = false;
  /// What it was told, or had before.
  Values told_;
  std::shared_ptr<void> regularly_;
};

}  // namespace pongsim::web::foxglove
