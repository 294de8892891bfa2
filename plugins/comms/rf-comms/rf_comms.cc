#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "pongsim/comms_system.hh"
#include "pongsim/parameter_group.hh"
#include "radio.hh"

namespace pongsim {

namespace {

/// Carries messages over radios that lose some of them.
class RFComms : public CommsSystem {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Carries messages between robots over simulated radios, with losses.", Declaration::Place::kWorld);
    declaration.element("range_config",
                        "propagation: `<max_range>` 50 m, beyond which nothing is received (0: no limit), "
                        "`<fading_exponent>` 2.5, `<l0>` 40, the loss at one metre [dB], `<sigma>` 10, the standard "
                        "deviation of the received power [dB]");
    declaration.element(
        "radio_config",
        "properties of the radios: `<capacity>` 54000000 bit/s, `<tx_power>` 27 dBm, `<noise_floor>` -90 "
        "dBm, `<modulation>` QPSK, the only one");
    CommsSystem::declare(declaration);
  }

  void configure(const SystemContext& context) override {
    random_ = &context.random;
    Declaration range;
    range.parameter("max_range", &settings_.maxRange, "m", "").atLeast(0).mayBeInfinite();
    range.parameter("fading_exponent", &settings_.fadingExponent, "", "").atLeast(0);
    range.parameter("l0", &settings_.lossAtOneMetre, "dB", "");
    range.parameter("sigma", &settings_.sigma, "dB", "").atLeast(0);
    readGroup(context, "range_config", range);
    std::string modulation = "QPSK";
    Declaration radio;
    radio.parameter("capacity", &settings_.capacity, "bit/s", "").atLeast(0).mayBeInfinite();
    radio.parameter("tx_power", &settings_.sendingPower, "dBm", "");
    radio.parameter("noise_floor", &settings_.noiseFloor, "dBm", "");
    radio.parameter("modulation", &modulation, "", "");
    readGroup(context, "radio_config", radio);
    if (modulation != "QPSK") {
      context.diagnostics.warning(context.sdf.child("radio_config")->child("modulation")->position,
                                  "<modulation> '" + modulation + "' is unknown: QPSK is used, as in Fortress");
    }
    CommsSystem::configure(context);
  }

  void reset() override {
    CommsSystem::reset();
    windows_.clear();
  }

  void transfer(StateArchive& archive) override {
    CommsSystem::transfer(archive);
    std::vector<std::string> addresses;
    for (const auto& [address, windows] : windows_) addresses.push_back(address);
    archive(addresses);
    if (archive.isGiving()) windows_.clear();
    for (const std::string& address : addresses) archive(windows_[address]);
  }

 protected:
  bool carries(const Radio& from, const Radio& to, Time now, ignition::msgs::Dataframe& message) override {
    const std::uint64_t bytes = message.data().size();
    if (const auto bits = windows_[from.address].sent.add(now, bytes, settings_.capacity)) {
      tooMuch(from.address, "sent", *bits);
      return false;
    }
    const double distance = (from.model.pose().position - to.model.pose().position).norm();
    double power = meanReceivedPower(settings_, distance);
    if (settings_.sigma > 0 && std::isfinite(power)) power = random_->normal(power, settings_.sigma);
    const double loss = lossProbability(bitErrorRate(settings_, power), bytes);
    // as in Fortress, which draws a number even if the result is certain
    if (!(random_->uniform() > loss)) return false;
    if (const auto bits = windows_[to.address].received.add(now, bytes, settings_.capacity)) {
      tooMuch(to.address, "received", *bits);
      return false;
    }
    auto& entry = *message.mutable_header()->add_data();
    entry.set_key("rssi");
    entry.add_value(std::to_string(power));
    return true;
  }

 private:
  struct Windows {
    RateWindow sent;
    RateWindow received;

    void transfer(StateArchive& archive) {
      archive(sent);
      archive(received);
    }
  };

  void tooMuch(const std::string& address, const char* what, double bits) {
    warnSeldom("the radio of '" + address + "' is at its capacity: " + std::to_string(bits) + " bits " + what +
               " in a second, " + std::to_string(settings_.capacity) + " are allowed; the message is lost");
  }

  RadioSettings settings_;
  Random* random_ = nullptr;
  /// By address.
  std::map<std::string, Windows> windows_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::RFComms, "ignition::gazebo::systems::RFComms", "gz::sim::systems::RFComms");
