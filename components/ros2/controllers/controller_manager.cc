#include "ros2/controllers/controller_manager.hh"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "pongsim/parameters.hh"
#include "ros2/controllers/controller_types.hh"
#include "ros2/node/stamp.hh"

namespace pongsim::ros2 {

namespace {

/// Parameters that every node or controller may have.
constexpr const char* kCommonParameters[] = {"type", "use_sim_time", "is_async", "params_file", "fallback_controllers"};

std::string named(const std::string& name) { return "controller '" + name + "'"; }

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

Outcome<void> refused(std::string why) { return {std::move(why)}; }

}  // namespace

ControllerManager::ControllerManager(RosNode& beside, HardwareInterfaces& hardware, const Model& model,
                                     Node& simulation, const Logger& log, Options options)
    : options_(std::move(options)),
      hardware_(hardware),
      model_(model),
      simulation_(simulation),
      log_(log),
      node_(beside, {options_.name, options_.nameSpace, beside.options().prefersOlder}),
      parameters_(node_, clock()) {
  parameters_.allowUndeclared();
  // those of its node, which have nested maps of its controllers
  for (const auto& [name, value] : options_.files.valuesOf(node_.fullName())) {
    if (value.type != rcl_interfaces::ParameterType::kParameterNotSet) parameters_.set({{name, value}});
  }
  parameters_.set(
      {{"update_rate", parameterOf(static_cast<std::int64_t>(options_.rate))}, {"use_sim_time", parameterOf(true)}});
}

ControllerManager::~ControllerManager() = default;

std::function<builtin_interfaces::Time()> ControllerManager::clock() {
  return [this] { return stampOf(now_); };
}

ControllerManager::Loaded* ControllerManager::find(const std::string& name) {
  const auto found = std::ranges::find(controllers_, name, &Loaded::name);
  return found == controllers_.end() ? nullptr : &*found;
}

std::optional<std::string> ControllerManager::parameterText(const std::string& name) const {
  const auto values = parameters_.get({name});
  if (values.empty() || values[0].type != rcl_interfaces::ParameterType::kParameterString) return std::nullopt;
  return values[0].string_value;
}

std::vector<std::string> ControllerManager::parameterTexts(const std::string& name) const {
  const auto values = parameters_.get({name});
  if (values.empty()) return {};
  if (values[0].type == rcl_interfaces::ParameterType::kParameterString) return {values[0].string_value};
  return values[0].string_array_value;
}

/// The files of the manager, then those that a spawner names for the controller.
ParameterValues ControllerManager::valuesFor(const std::string& controller, std::string& error) const {
  ParameterFiles files = options_.files;
  for (const std::string& file : parameterTexts(controller + ".params_file")) {
    const std::string wrong = files.read(file);
    if (!wrong.empty()) error = "file '" + file + "': " + wrong;
  }
  const std::string space = options_.nameSpace == "/" ? "" : options_.nameSpace;
  return files.valuesOf(space + "/" + controller);
}

std::string ControllerManager::typeOf(const std::string& controller, std::string& error) const {
  if (const auto type = parameterText(controller + ".type")) return *type;
  const ParameterValues values = valuesFor(controller, error);
  const auto found = values.find("type");
  return found == values.end() ? "" : found->second.string_value;
}

std::vector<std::pair<std::string, std::string>> ControllerManager::unknownTypes() const {
  std::vector<std::pair<std::string, std::string>> unknown;
  const auto listed = parameters_.list({}, 0).names;
  for (const std::string& name : listed) {
    constexpr std::string_view kSuffix = ".type";
    if (!name.ends_with(kSuffix)) continue;
    const auto type = parameterText(name);
    if (!type || makeController(*type) != nullptr) continue;
    unknown.emplace_back(name.substr(0, name.size() - kSuffix.size()), *type);
  }
  return unknown;
}

Outcome<void> ControllerManager::load(const std::string& name) {
  if (find(name) != nullptr) return refused(named(name) + " is already loaded");
  if (const auto error = rosNameError("/" + name)) return refused(named(name) + ": its name " + *error);
  std::string error;
  const std::string type = typeOf(name, error);
  if (type.empty()) {
    return refused(named(name) + " has no 'type' in the parameters of '" + node_.fullName() + "'" +
                   (error.empty() ? "" : ", and " + error));
  }
  std::unique_ptr<Controller> controller = makeController(type);
  if (controller == nullptr) {
    return refused(named(name) + " is a " + type +
                   ", which does not run inside the simulation; ~/list_controller_types has those that do");
  }
  Loaded& added = controllers_.emplace_back();
  added.name = name;
  added.type = type;
  added.controller = std::move(controller);
  added.remaps = options_.remaps;
  added.remaps.addArguments(parameterTexts(name + ".node_options_args"));
  added.node.emplace(node_, RosNode::Options{name, options_.nameSpace, node_.options().prefersOlder});
  ++version_;
  log_.info("loaded " + named(name) + " of class " + added.type);
  return {};
}

Outcome<void> ControllerManager::configure(const std::string& name) {
  Loaded* found = find(name);
  if (found == nullptr) return refused(named(name) + " is not loaded");
  if (found->state == State::kActive) return refused(named(name) + " is active and can't be configured");
  Loaded& loaded = *found;
  // as new: its topics end before they begin again
  loaded.parameterServices.reset();
  loaded.controller = makeController(loaded.type);
  loaded.state = State::kUnconfigured;
  std::string error;
  loaded.parameters = ControllerParameters(valuesFor(name, error));
  if (!error.empty()) return refused(named(name) + ": parameter " + error);
  for (const char* common : kCommonParameters) loaded.parameters.ignore(common);
  loaded.rate = loaded.parameters.number("update_rate", 0);
  if (loaded.rate < 0) loaded.parameters.complain("'update_rate' must not be below zero");
  const RosNode::Quiet quiet(*loaded.node);
  const double rate = loaded.rate > 0 ? std::min(loaded.rate, options_.rate) : options_.rate;
  const ControllerSetup setup{*loaded.node,
                              loaded.remaps,
                              loaded.parameters,
                              options_.frames,
                              simulation_,
                              model_,
                              log_,
                              [this] { return now_; },
                              rate,
                              options_.tellsTransforms};
  Outcome<void> outcome;
  try {
    outcome = loaded.controller->configure(setup);
  } catch (const std::invalid_argument& invalid) {
    // a name that a rule gives a topic
    outcome.error = invalid.what();
  }
  if (!loaded.parameters.errors().empty()) outcome.error = "parameter " + joined(loaded.parameters.errors());
  if (!outcome) {
    loaded.controller = makeController(loaded.type);
    return refused(named(name) + ": " + outcome.error);
  }
  const std::vector<std::string> unknown = loaded.parameters.unknown();
  if (!unknown.empty()) log_.warning(named(name) + ": parameters without effect: " + joined(unknown));
  loaded.wanted = loaded.controller->interfaces();
  loaded.state = State::kInactive;
  loaded.parameterServices.emplace(*loaded.node, clock());
  for (const auto& [parameter, value] : loaded.parameters.asked()) {
    Parameters::Descriptor descriptor;
    descriptor.name = parameter;
    loaded.parameterServices->declare(std::move(descriptor), value);
  }
  ++version_;
  return {};
}

Outcome<void> ControllerManager::cleanUp(const std::string& name) {
  Loaded* loaded = find(name);
  if (loaded == nullptr) return refused(named(name) + " is not loaded");
  if (loaded->state == State::kActive) return refused(named(name) + " is active");
  loaded->parameterServices.reset();
  loaded->controller = makeController(loaded->type);
  loaded->wanted = {};
  loaded->state = State::kUnconfigured;
  ++version_;
  return {};
}

Outcome<void> ControllerManager::unload(const std::string& name) {
  Loaded* loaded = find(name);
  if (loaded == nullptr) return refused(named(name) + " is not loaded");
  if (loaded->state == State::kActive) return refused(named(name) + " is active; deactivate it first");
  std::erase_if(controllers_, [&name](const Loaded& each) { return each.name == name; });
  ++version_;
  return {};
}

Outcome<Controller::Loan> ControllerManager::loanFor(const Loaded& controller, const std::vector<std::string>& freed) {
  Controller::Loan loan;
  for (const std::string& name : controller.wanted.commands) {
    const HardwareInterfaces::Command* command = hardware_.command(name);
    if (command == nullptr)
      return {{},
              named(controller.name) + " needs command interface '" + name + "', which <ros2_control> does not list"};
    const bool isFree = command->owner.empty() || std::ranges::find(freed, command->owner) != freed.end();
    if (!isFree) {
      return {{},
              named(controller.name) + " needs command interface '" + name + "', which controller '" + command->owner +
                  "' holds"};
    }
    loan.commands.push_back(command);
  }
  for (const std::string& name : controller.wanted.states) {
    const HardwareInterfaces::State* state = hardware_.state(name);
    if (state == nullptr)
      return {{}, named(controller.name) + " needs state interface '" + name + "', which <ros2_control> does not list"};
    loan.states.push_back(state);
  }
  if (controller.wanted.allStates) {
    for (const HardwareInterfaces::State& state : hardware_.states()) loan.states.push_back(&state);
  }
  return {std::move(loan), {}};
}

Outcome<void> ControllerManager::switchTo(std::vector<std::string> activate, std::vector<std::string> deactivate,
                                          bool isStrict) {
  std::string problems;
  const auto leaveOut = [&](std::vector<std::string>& names, const auto& whyNot) {
    std::erase_if(names, [&](const std::string& name) {
      const std::string why = whyNot(name);
      if (why.empty()) return false;
      problems += (problems.empty() ? "" : "; ") + why;
      return true;
    });
  };
  leaveOut(deactivate, [this](const std::string& name) {
    const Loaded* loaded = find(name);
    if (loaded == nullptr) return named(name) + " is not loaded";
    return loaded->state == State::kActive ? "" : named(name) + " is not active";
  });
  std::vector<std::string> claimed;
  leaveOut(activate, [&](const std::string& name) -> std::string {
    const Loaded* loaded = find(name);
    if (loaded == nullptr) return named(name) + " is not loaded";
    const bool restarts = std::ranges::find(deactivate, name) != deactivate.end();
    if (loaded->state == State::kActive && !restarts) return named(name) + " is already active";
    if (loaded->state == State::kUnconfigured) return named(name) + " is not configured";
    const Outcome<Controller::Loan> loan = loanFor(*loaded, deactivate);
    if (!loan) return loan.error;
    for (const std::string& command : loaded->wanted.commands) {
      if (std::ranges::find(claimed, command) != claimed.end())
        return named(name) + " needs '" + command + "', which another one of them takes";
    }
    claimed.insert(claimed.end(), loaded->wanted.commands.begin(), loaded->wanted.commands.end());
    return {};
  });
  if (isStrict && !problems.empty()) return refused(problems);
  for (const std::string& name : deactivate) this->deactivate(*find(name));
  for (const std::string& name : activate) {
    if (const Outcome<void> outcome = this->activate(*find(name)); !outcome) {
      problems += (problems.empty() ? "" : "; ") + named(name) + ": " + outcome.error;
    }
  }
  ++version_;
  if (!problems.empty()) log_.warning(problems);
  // what could not be done is an error for strict switches alone, unless nothing was done
  return isStrict || (activate.empty() && deactivate.empty()) ? refused(problems) : refused("");
}

Outcome<void> ControllerManager::activate(Loaded& controller) {
  Outcome<Controller::Loan> loan = loanFor(controller, {});
  if (!loan) return refused(loan.error);
  controller.loan = *loan;
  for (const std::string& name : controller.wanted.commands) {
    HardwareInterfaces::Command& command = *hardware_.command(name);
    command.owner = controller.name;
    command.driver->claim(command.joint, command.interface);
    controller.claimed.push_back(name);
  }
  controller.last = now_;
  controller.state = State::kActive;
  if (Outcome<void> outcome = controller.controller->activate(controller.loan, now_); !outcome) {
    deactivate(controller);
    return outcome;
  }
  log_.info("activated " + named(controller.name));
  return {};
}

void ControllerManager::deactivate(Loaded& controller) {
  controller.controller->deactivate();
  for (const std::string& name : std::exchange(controller.claimed, {})) {
    HardwareInterfaces::Command& command = *hardware_.command(name);
    command.owner.clear();
    command.driver->release(command.joint, command.interface);
  }
  controller.loan = {};
  controller.state = State::kInactive;
  log_.info("deactivated " + named(controller.name));
}

std::vector<std::string> ControllerManager::replacedTopics() const {
  std::vector<std::string> topics;
  for (const Loaded& each : controllers_) {
    if (each.state != State::kActive) continue;
    for (const std::string& topic : each.controller->replacedTopics()) topics.push_back(topic);
  }
  return topics;
}

std::size_t ControllerManager::dispatch() {
  std::size_t count = node_.mailbox().dispatch();
  for (Loaded& each : controllers_) count += each.node->mailbox().dispatch();
  return count;
}

void ControllerManager::update(Time now) {
  now_ = now;
  if (now - last_ < periodOf(options_.rate)) return;
  last_ = now;
  for (Loaded& each : controllers_) {
    if (each.state != State::kActive) continue;
    if (each.rate > 0 && now - each.last < periodOf(each.rate)) continue;
    const double period = toSeconds(now - each.last);
    each.last = now;
    each.controller->update(now, period);
  }
}

void ControllerManager::reset() {
  now_ = last_ = Time::zero();
  for (Loaded& each : controllers_) {
    each.last = Time::zero();
    if (each.state == State::kActive) each.controller->reset();
  }
}

void ControllerManager::transfer(StateArchive& archive) {
  archive(now_);
  archive(last_);
  // the controllers are what nodes have made of them: a state is that of the same ones
  std::uint64_t count = controllers_.size();
  archive(count);
  archive.check(count == controllers_.size());
  for (Loaded& each : controllers_) {
    std::string name = each.name + " " + each.type;
    archive(name);
    archive.check(name == each.name + " " + each.type);
    State state = each.state;
    archive(state, State::kActive);
    archive.check(state == each.state);
    archive(each.last);
    if (each.state == State::kActive) each.controller->transfer(archive);
  }
}

}  // namespace pongsim::ros2
