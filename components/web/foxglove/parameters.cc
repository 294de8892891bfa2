#include "web/foxglove/parameters.hh"

#include <ignition/msgs/physics.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <array>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include "web/foxglove/fields.hh"
#include "web/foxglove/status.hh"

namespace pongsim::web::foxglove {

namespace {

using nlohmann::json;
namespace im = ignition::msgs;

constexpr std::string_view kWorld = "/world/";
// maximum per message of a client
constexpr std::size_t kMostNames = 1000;

/// @return The names in a message's list; nothing if it has no valid one.
std::optional<std::set<std::string>> namesIn(const json& message) {
  const auto list = listField(message, "parameterNames");
  if (!list || list->size() > kMostNames) return std::nullopt;
  std::set<std::string> names;
  for (const json& name : *list) {
    if (!name.is_string()) return std::nullopt;
    names.insert(name.get<std::string>());
  }
  return names;
}

std::string wrongNames(const char* operation) {
  return "'" + std::string(operation) + "' must have a list 'parameterNames' of up to " + std::to_string(kMostNames) +
         " texts";
}

std::optional<double> numberOf(const json& value) {
  if (!value.is_number()) return std::nullopt;
  const auto number = value.get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<double> numberAboveZero(const json& value) {
  const auto number = numberOf(value);
  return number && *number > 0 ? number : std::nullopt;
}

/// The request to a world that sets a parameter.
struct Wish {
  /// Name after "/world/W/".
  const char* service = "set_physics";
  std::shared_ptr<Message> request;
};

std::string wishPaused(const json& value, Wish& wish) {
  if (!value.is_boolean()) return "must be true or false";
  const auto control = std::make_shared<im::WorldControl>();
  control->set_pause(value.get<bool>());
  wish = {"control", control};
  return {};
}

std::string wishFactor(const json& value, Wish& wish) {
  const auto factor = numberAboveZero(value);
  if (!factor) return "must be a number above 0";
  const auto physics = std::make_shared<im::Physics>();
  physics->set_real_time_factor(*factor);
  wish.request = physics;
  return {};
}

std::string wishStep(const json& value, Wish& wish) {
  const auto step = numberAboveZero(value);
  if (!step) return "must be a number above 0, in seconds";
  const auto physics = std::make_shared<im::Physics>();
  physics->set_max_step_size(*step);
  wish.request = physics;
  return {};
}

std::string wishGravity(const json& value, Wish& wish) {
  std::vector<double> numbers;
  for (const json& each : value.is_array() && value.size() == 3 ? value : json::array()) {
    if (const auto number = numberOf(each)) numbers.push_back(*number);
  }
  if (numbers.size() != 3) return "must be a list of three numbers, in m/s^2";
  const auto physics = std::make_shared<im::Physics>();
  physics->mutable_gravity()->set_x(numbers[0]);
  physics->mutable_gravity()->set_y(numbers[1]);
  physics->mutable_gravity()->set_z(numbers[2]);
  wish.request = physics;
  return {};
}

/// A kind of parameter, which each world has.
struct Kind {
  std::string_view name;
  /// @return What is wrong with a value, as the end of a sentence; or an empty text and the request.
  std::string (*wish)(const json& value, Wish& wish);
};
constexpr std::array kKinds{Kind{"paused", wishPaused}, Kind{"real_time_factor", wishFactor},
                            Kind{"max_step_size", wishStep}, Kind{"gravity", wishGravity}};

json jsonOf(const std::string& name, const json& value) {
  json parameter = {{"name", name}, {"value", value}};
  // 1.0 is not an integer
  if (value.is_number()) parameter["type"] = "float64";
  if (value.is_array()) parameter["type"] = "float64_array";
  return parameter;
}

}  // namespace

struct Parameters::Setting {
  std::mutex mutex;
  std::optional<std::string> id;
  /// Values accepted by the worlds.
  Values taken;
};

Parameters::Parameters(std::shared_ptr<Client> client, std::shared_ptr<Worlds> worlds)
    : client_(std::move(client)), worlds_(std::move(worlds)) {}

/// @return All parameters with known values.
Parameters::Values Parameters::values() const {
  Values values;
  for (const auto& world : worlds_->all()) {
    const std::optional<WorldSettings> settings = world->settings();
    if (!settings) continue;
    const std::string prefix = std::string(kWorld) + world->world() + "/";
    values[prefix + "paused"] = settings->isPaused;
    values[prefix + "real_time_factor"] = settings->realTimeFactor;
    if (settings->stepSize) values[prefix + "max_step_size"] = *settings->stepSize;
    values[prefix + "gravity"] = settings->gravity;
  }
  return values;
}

void Parameters::tell(const Values& values, const std::optional<std::string>& id) {
  json list = json::array();
  for (const auto& [name, value] : values) list.push_back(jsonOf(name, value));
  json message = {{"op", "parameterValues"}, {"parameters", std::move(list)}};
  if (id) message["id"] = *id;
  client_->sendText(textOf(message));
}

std::string Parameters::get(const json& message) {
  const auto names = namesIn(message);
  if (!names) return wrongNames("getParameters");
  Values found = values();
  if (!names->empty()) std::erase_if(found, [&](const auto& each) { return !names->contains(each.first); });
  tell(found, textField(message, "id"));
  return {};
}

std::string Parameters::set(const json& message) {
  const auto list = listField(message, "parameters");
  if (!list || list->size() > kMostNames) {
    return "'setParameters' must have a list 'parameters' of up to " + std::to_string(kMostNames) + " parameters";
  }
  // the response is sent when the last world has answered and the last owner is destroyed
  const std::shared_ptr<Setting> setting(new Setting{{}, textField(message, "id"), {}},
                                         [self = shared_from_this()](Setting* done) {
                                           if (done->id) self->tell(done->taken, done->id);
                                           delete done;
                                         });
  std::string wrong;
  for (const json& parameter : *list) {
    const std::string what = setOne(parameter, setting);
    if (!what.empty()) wrong += (wrong.empty() ? "" : "; ") + what;
  }
  return wrong;
}

std::string Parameters::setOne(const json& parameter, const std::shared_ptr<Setting>& setting) {
  const auto name = textField(parameter, "name");
  if (!name || !parameter.contains("value")) return "a parameter must have a 'name' and a 'value'";
  if (!client_->mayWrite()) return "this client is read-only: '" + *name + "' is not set";
  for (const auto& world : worlds_->all()) {
    const std::string prefix = std::string(kWorld) + world->world() + "/";
    if (!name->starts_with(prefix)) continue;
    for (const Kind& kind : kKinds) {
      if (name->substr(prefix.size()) != kind.name) continue;
      const json& value = parameter.at("value");
      Wish wish;
      if (const std::string wrong = kind.wish(value, wish); !wrong.empty()) return "'" + *name + "' " + wrong;
      world->request({prefix + wish.service, wish.request->GetTypeName(), "ignition.msgs.Boolean"}, wish.request,
                     [client = client_, setting, name = *name, value](const CallResult& result, const Message&) {
                       if (!result) {
                         return sendStatus(*client, StatusLevel::kError, "'" + name + "' is not set: " + result.error);
                       }
                       const std::lock_guard lock(setting->mutex);
                       setting->taken[name] = value;
                     });
      return {};
    }
  }
  return "there is no parameter '" + name->substr(0, 200) + "'";
}

std::string Parameters::subscribe(const json& message) {
  const auto names = namesIn(message);
  if (!names) return wrongNames("subscribeParameterUpdates");
  const Values known = values();
  std::string unknown;
  for (const std::string& name : *names) {
    if (known.contains(name)) {
      wanted_.insert(name);
    } else if (unknown.empty()) {
      unknown = "there is no parameter '" + name.substr(0, 200) + "'";
    }
  }
  wantsAll_ = wantsAll_ || names->empty();
  if (!regularly_ && (wantsAll_ || !wanted_.empty())) {
    told_ = known;
    regularly_ = client_->callRegularly(weak_from_this());
  }
  return unknown;
}

std::string Parameters::unsubscribe(const json& message) {
  const auto names = namesIn(message);
  if (!names) return wrongNames("unsubscribeParameterUpdates");
  for (const std::string& name : *names) wanted_.erase(name);
  if (names->empty()) {
    wanted_.clear();
    wantsAll_ = false;
  }
  if (wanted_.empty() && !wantsAll_) regularly_.reset();
  return {};
}

void Parameters::called() {
  Values now = values();
  if (now == told_) return;
  Values changed;
  for (const auto& [name, value] : now) {
    const auto before = told_.find(name);
    if (before != told_.end() && before->second == value) continue;
    if (wantsAll_ || wanted_.contains(name)) changed[name] = value;
  }
  told_ = std::move(now);
  if (!changed.empty()) tell(changed, std::nullopt);
}

}  // namespace pongsim::web::foxglove
