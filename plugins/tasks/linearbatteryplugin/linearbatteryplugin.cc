#include <ignition/msgs/battery_state.pb.h>
#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/empty.pb.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "linear_cell.hh"
#include "pongsim/battery.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Simulates a battery of a model.
class LinearBatteryPlugin : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(
        "Simulates a battery; the model's joints move freely when it is empty. It starts to drain when a joint is "
        "driven.",
        Declaration::Place::kModel);
    declareCell(declaration);
    declaration.parameter("power_load", &powerLoad_, "W", "power drawn by the model");
    declaration.parameter("start_draining", &startsDraining_, "", "drains from the start");
    declaration.parameter("power_draining_topic", &drainTopics_, "", "topic on which any message starts the drain");
    declaration.parameter("stop_power_draining_topic", &stopTopics_, "", "topic on which any message stops the drain");
    declaration.parameter("enable_recharge", &isRechargeable_, "", "can be charged, up to 90 %");
    declaration.parameter("charging_time", &chargingTime_, "h", "time from empty to full; required for charging")
        .above(0);
    declaration.element("recharge_by_topic", "if present with any value, charging can also be controlled by topics");
    declaration.parameter("invert_current_sign", &invertsCurrent_, "", "publishes discharge currents as negative");
    declaration.publishes("/model/M/battery/<battery_name>/state", "ignition.msgs.BatteryState",
                          "50 per simulated second; `percentage` is from 0 to 1, with `<fix_issue_225>` from 0 to 100");
    for (const char* what : {"start", "stop"}) {
      const std::string name = std::string("/model/M/battery/<battery_name>/recharge/") + what;
      const std::string text = std::string(what) + "s charging, whatever the message contains";
      declaration.serves(name, "ignition.msgs.Boolean", "ignition.msgs.Empty", text);
      declaration.subscribes(name, "ignition.msgs.Boolean", text + "; with `<recharge_by_topic>`");
    }
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    model_ = context.model;
    checkCell(context);
    if (isRechargeable_ && !chargingTime_) {
      refuse(context.sdf, "no <charging_time> is given for a rechargeable battery",
             "write <charging_time>HOURS</charging_time>");
    }
    if (!powerLoad_) {
      context.diagnostics.warning(context.sdf.position, "no <power_load> is given: the model draws no power from it");
    }
    parameters_.chargingTime = chargingTime_.value_or(1);
    cell_.emplace(parameters_);
    Outcome<Battery> added = Batteries(context.world).add(*model_, name_, cell_->stateOfCharge());
    if (!added) refuse(*context.sdf.child("battery_name"), added.error);
    battery_ = *added;
    battery_->setLoad("model", powerLoad_.value_or(0));
    isDraining_ = startsDraining_;
    openTopics(context);
  }

  void update(const StepInfo& info) override {
    if (info.paused) return;
    if (!isDraining_) isDraining_ = std::ranges::any_of(joints_, [](const Joint& joint) { return joint.isDriven(); });
    if (!isDraining_ && !isCharging_) return;
    const bool hadCharge = cell_->stateOfCharge() >= 0;
    cell_->update(toSeconds(info.dt), isDraining_ ? battery_->load() : 0, isCharging_);
    battery_->setCharge(cell_->stateOfCharge());
    if (hadCharge && cell_->stateOfCharge() < 0) {
      log_->warning("the battery '" + name_ + "' is empty: the model's joints move freely");
    }
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused || !schedule_.isDue(info.time) || !state_.hasSubscribers()) return;
    setStamp(info.time, *message_.mutable_header());
    message_.set_voltage(cell_->voltage());
    message_.set_current(invertsCurrent_ ? -cell_->current() : cell_->current());
    message_.set_charge(cell_->charge());
    message_.set_capacity(parameters_.capacity);
    message_.set_percentage(cell_->stateOfCharge() * (parameters_.countsOnce ? 100 : 1));
    message_.set_power_supply_status(status());
    state_.publish(message_);
  }

  void worldChanged() override {
    std::erase_if(joints_, [](const Joint& joint) { return !joint.exists(); });
  }

  void reset() override {
    cell_->reset();
    isDraining_ = startsDraining_;
    isCharging_ = false;
    schedule_.reset();
    joints_ = model_->joints();
    battery_->setCharge(cell_->stateOfCharge());
  }

  void transfer(StateArchive& archive) override {
    cell_->transfer(archive);
    archive(isDraining_);
    archive(isCharging_);
    schedule_.transfer(archive);
    if (archive.isGiving()) battery_->setCharge(cell_->stateOfCharge());
  }

 private:
  using Status = ignition::msgs::BatteryState;

  void declareCell(Declaration& declaration) {
    declaration.parameter("battery_name", &name_, "", "name of the battery").required();
    declaration.parameter("voltage", &parameters_.voltage, "V", "voltage at the start").required().above(0);
    declaration.parameter("open_circuit_voltage_constant_coef", &parameters_.constantVoltage, "V",
                          "voltage of the full battery without load");
    declaration.parameter("open_circuit_voltage_linear_coef", &parameters_.linearVoltage, "V",
                          "change of that voltage when empty, usually negative");
    declaration.parameter("capacity", &parameters_.capacity, "Ah", "charge of the full battery").required().above(0);
    declaration.parameter("initial_charge", &initialCharge_, "Ah", "charge at the start").otherwise("`<capacity>`");
    declaration.parameter("resistance", &parameters_.resistance, "Ohm", "internal resistance");
    declaration.parameter("smooth_current_tau", &parameters_.smoothing, "s",
                          "time constant of the current's low-pass filter");
    declaration.parameter("fix_issue_225", &parameters_.countsOnce, "",
                          "correct drain; otherwise about a hundred times too fast");
  }

  /// Corrects invalid parameters that have a sensible value, with a warning.
  void checkCell(const SystemContext& context) {
    double& charge = parameters_.initialCharge;
    charge = initialCharge_.value_or(parameters_.capacity);
    if (!(charge >= 0 && charge <= parameters_.capacity)) {
      charge = std::clamp(charge, 0.0, parameters_.capacity);
      context.diagnostics.warning(context.sdf.child("initial_charge")->position,
                                  "<initial_charge> is not between 0 and the <capacity>: " +
                                      std::string(charge == 0 ? "0" : "that") + " is taken");
    }
    if (parameters_.smoothing > 0) return;
    parameters_.smoothing = 1;
    context.diagnostics.warning(context.sdf.child("smooth_current_tau")->position,
                                "<smooth_current_tau> must be above 0: 1 is used");
  }

  void openTopics(const SystemContext& context) {
    joints_ = model_->joints();
    const std::string prefix = cleanTopic("/model/" + std::string(model_->name()) + "/battery/" + name_);
    state_ = context.node.advertise<Status>(prefix + "/state");
    for (const std::string& topic : drainTopics_) listen(context.node, topic, true);
    for (const std::string& topic : stopTopics_) listen(context.node, topic, false);
    if (!isRechargeable_) return;
    for (const bool starts : {true, false}) {
      const std::string name = prefix + (starts ? "/recharge/start" : "/recharge/stop");
      services_.push_back(
          context.node.serve<ignition::msgs::Boolean, ignition::msgs::Empty>(name, [this, starts](const auto&, auto&) {
            isCharging_ = starts;
            return ServiceAnswer(true);
          }));
      if (context.sdf.child("recharge_by_topic") == nullptr) continue;
      subscriptions_.push_back(
          context.node.subscribe<ignition::msgs::Boolean>(name, [this, starts](const auto&) { isCharging_ = starts; }));
    }
  }

  void listen(Node& node, const std::string& named, bool drains) {
    const std::string topic = cleanTopic(named);
    subscriptions_.push_back(node.subscribeAnyType(topic, [this, drains](auto, auto) { isDraining_ = drains; }));
  }

  Status::PowerSupplyStatus status() const {
    if (isCharging_) return Status::CHARGING;
    if (isDraining_) return Status::DISCHARGING;
    return cell_->stateOfCharge() > 0.9 ? Status::FULL : Status::NOT_CHARGING;
  }

  std::string name_;
  LinearCell::Parameters parameters_;
  std::optional<double> initialCharge_, powerLoad_, chargingTime_;
  bool startsDraining_ = false;
  bool isRechargeable_ = false;
  bool invertsCurrent_ = false;
  std::vector<std::string> drainTopics_, stopTopics_;

  std::optional<Model> model_;
  std::vector<Joint> joints_;
  std::optional<LinearCell> cell_;
  std::optional<Battery> battery_;
  bool isDraining_ = false;
  bool isCharging_ = false;
  Schedule schedule_{periodOf(50)};
  const Logger* log_ = nullptr;
  Publisher state_;
  Status message_;
  std::vector<Service> services_;
  std::vector<Subscription> subscriptions_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::LinearBatteryPlugin, "ignition::gazebo::systems::LinearBatteryPlugin",
                      "gz::sim::systems::LinearBatteryPlugin");
