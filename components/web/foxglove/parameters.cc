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
struct SetRequest {
  /// Name after "/world/W/".
  const char* service = "set_physics";
  std::shared_ptr<Message> message;
};

std::string requestPaused(const json& value, SetRequest& request) {
  if (!value.is_boolean()) return "must be true or false";
  const auto control = std::make_shared<im::WorldControl>();
  control->set_pause(value.get<bool>());
  request = {"control", control};
  return {};
}

std::string requestFactor(const json& value, SetRequest& request) {
  const auto factor = numberAboveZero(value);
  if (!factor) return "must be a number above 0";
  const auto physics = std::make_shared<im::Physics>();
  physics->set_real_time_factor(*factor);
  request.message = physics;
  return {};
}

std::string requestStep(const json& value, SetRequest& request) {
  const auto step = numberAboveZero(value);
  if (!step) return "must be a number above 0, in seconds";
  const auto physics = std::make_shared<im::Physics>();
  physics->set_max_step_size(*step);
  request.message = physics;
  return {};
}

std::string requestGravity(const json& value, SetRequest& request) {
  std::vector<double> numbers;
  for (const json& each : value.is_array() && value.size() == 3 ? value : json::array()) {
    if (const auto number = numberOf(each)) numbers.push_back(*number);
  }
  if (numbers.size() != 3) return "must be a list of three numbers, in m/s^2";
  const auto physics = std::make_shared<im::Physics>();
  physics->mutable_gravity()->set_x(numbers[0]);
  physics->mutable_gravity()->set_y(numbers[1]);
  physics->mutable_gravity()->set_z(numbers[2]);
  request.message = physics;
  return {};
}

/// A parameter that each world has.
struct Parameter {
  std::string_view name;
  /// @return What is wrong with a value, as the end of a sentence; or an empty text and the request.
  std::string (*makeRequest)(const json& value, SetRequest& request);
};
constexpr std::array kParameters{Parameter{"paused", requestPaused}, Parameter{"real_time_factor", requestFactor},
                                 Parameter{"max_step_size", requestStep}, Parameter{"gravity", requestGravity}};

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
  /// Values that the worlds have set.
  Values accepted;
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

void Parameters::send(const Values& values, const std::optional<std::string>& id) {
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
  send(found, textField(message, "id"));
  return {};
}

std::string Parameters::set(const json& message) {
  const auto list = listField(message, "parameters");
  if (!list || list->size() > kMostNames) {
    return "'setParameters' must have a list 'parameters' of up to " + std::to_string(kMostNames) + " parameters";
  }
  // each request holds this: when the last world has answered, its deleter sends the response
  const std::shared_ptr<Setting> setting(new Setting{{}, textField(message, "id"), {}},
                                         [self = shared_from_this()](Setting* done) {
                                           if (done->id) self->send(done->accepted, done->id);
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
    for (const Parameter& known : kParameters) {
      if (name->substr(prefix.size()) != known.name) continue;
      const json& value = parameter.at("value");
      SetRequest request;
      if (const std::string wrong = known.makeRequest(value, request); !wrong.empty())
        return "'" + *name + "' " + wrong;
      world->request({prefix + request.service, request.message->GetTypeName(), "ignition.msgs.Boolean"},
                     request.message,
                     [client = client_, setting, name = *name, value](const CallResult& result, const Message&) {
                       if (!result) {
                         return sendStatus(*client, StatusLevel::kError, "'" + name + "' is not set: " + result.error);
                       }
                       const std::lock_guard lock(setting->mutex);
                       setting->accepted[name] = value;
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
    sent_ = known;
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
  if (now == sent_) return;
  Values changed;
  for (const auto& [name, value] : now) {
    const auto before = sent_.find(name);
    if (before != sent_.end() && before->second == value) continue;
    if (wantsAll_ || wanted_.contains(name)) changed[name] = value;
  }
  sent_ = std::move(now);
  if (!changed.empty()) send(changed, std::nullopt);
}

}  // namespace pongsim::web::foxglove
