#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/comms_system.hh"
#include "pongsim/parameter_group.hh"
#include "sonar_link.hh"

namespace pongsim {

namespace {

// limits of what is on its way
constexpr std::size_t kMostUnderWay = 10000;
constexpr std::size_t kMostBytesUnderWay = 64 << 20;

/// A message on its way.
struct Wave {
  ignition::msgs::Dataframe message;
  /// Where its sender was, world frame.
  Vector3 origin = Vector3::Zero();
  /// When it was sent.
  Time sent{0};

  void transfer(StateArchive& archive) {
    std::string bytes = message.SerializeAsString();
    archive(bytes);
    if (archive.isGiving()) archive.check(message.ParseFromString(bytes));
    archive(origin);
    archive(sent);
  }
};

/// Carries messages between robots at the speed of sound.
class AcousticComms final : public CommsSystem {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Carries messages between robots by sound: with a delay, a range, and losses.",
                   Declaration::Place::kWorld);
    declaration.parameter("max_range", &maxRange_, "m", "range of the sound").atLeast(0).mayBeInfinite();
    declaration.parameter("speed_of_sound", &speedOfSound_, "m/s", "speed of the sound").above(0);
    declaration
        .parameter("collision_time_per_byte", &timePerByte_, "s",
                   "for so long per byte of a message, its receiver receives nothing else")
        .atLeast(0);
    declaration
        .parameter("collision_time_packet_drop", &timePerLoss_, "s",
                   "for so long after a message was lost, its receiver receives nothing")
        .atLeast(0);
    declaration.element("propagation_model",
                        "losses by noise: `<source_power>` 2000 W, `<noise_level>` 1 dB, `<spectral_efficiency>` 7 "
                        "bit/s/Hz; without it there are none");
    CommsSystem::declare(declaration);
  }

  void configure(const SystemContext& context) override {
    random_ = &context.random;
    hasNoise_ = context.sdf.child("propagation_model") != nullptr;
    Declaration link;
    link.parameter("source_power", &link_.sourcePower, "W", "").above(0);
    link.parameter("noise_level", &link_.noiseLevel, "dB", "");
    link.parameter("spectral_efficiency", &link_.spectralEfficiency, "bit/s/Hz", "").above(0);
    // that of the run is used
    link.element("seed", "");
    readGroup(context, "propagation_model", link);
    CommsSystem::configure(context);
  }

  void preUpdate(const StepInfo& info) override {
    CommsSystem::preUpdate(info);
    if (info.paused) return;
    std::erase_if(underWay_, [&](Wave& wave) {
      const bool isOver = !isUnderWay(wave, info.time);
      if (isOver) bytesUnderWay_ -= wave.message.data().size();
      return isOver;
    });
  }

  void reset() override {
    CommsSystem::reset();
    underWay_.clear();
    bytesUnderWay_ = 0;
    deafUntil_.clear();
  }

  void transfer(StateArchive& archive) override {
    CommsSystem::transfer(archive);
    archive(underWay_);
    bytesUnderWay_ = 0;
    for (const Wave& wave : underWay_) bytesUnderWay_ += wave.message.data().size();
    archive.check(underWay_.size() <= kMostUnderWay && bytesUnderWay_ <= kMostBytesUnderWay);
    std::vector<std::string> addresses;
    for (const auto& [address, until] : deafUntil_) addresses.push_back(address);
    archive(addresses);
    if (archive.isGiving()) deafUntil_.clear();
    for (const std::string& address : addresses) archive(deafUntil_[address]);
  }

 protected:
  bool carries(const Radio& from, const Radio&, Time, ignition::msgs::Dataframe& message) override {
    if (underWay_.size() >= kMostUnderWay || bytesUnderWay_ + message.data().size() > kMostBytesUnderWay) {
      warnSeldom("a message from '" + from.address + "' was dropped: too many are on their way");
      return false;
    }
    bytesUnderWay_ += message.data().size();
    const auto& stamp = message.header().stamp();
    underWay_.push_back({message, from.model.pose().position,
                         std::chrono::seconds(stamp.sec()) + std::chrono::nanoseconds(stamp.nsec())});
    return false;
  }

 private:
  /// Delivers a message that has reached its receiver.
  /// @return Whether it has not, and may do so later.
  bool isUnderWay(const Wave& wave, Time now) {
    const std::string& address = wave.message.dst_address();
    const std::optional<Model> receiver = modelOf(address);
    if (!receiver) return false;
    const double covered = toSeconds(now - wave.sent) * speedOfSound_;
    // as in Gazebo, also if it has reached its receiver in this step
    if (covered > maxRange_) return false;
    if (covered < (receiver->pose().position - wave.origin).norm()) return true;
    if (isReceived(wave, covered, now)) {
      deafUntil_[address] = now + fromSeconds(timePerByte_ * static_cast<double>(wave.message.data().size()));
      deliver(address, wave.message);
    } else {
      Time& until = deafUntil_[address];
      until = std::max(until, now + fromSeconds(timePerLoss_));
    }
    return false;
  }

  bool isReceived(const Wave& wave, double distance, Time now) {
    const auto deaf = deafUntil_.find(wave.message.dst_address());
    if (deaf != deafUntil_.end() && now < deaf->second) return false;
    return !hasNoise_ || random_->uniform() >= packetLoss(link_, distance, wave.message.data().size());
  }

  double maxRange_ = 1000;
  double speedOfSound_ = 343;
  double timePerByte_ = 0;
  double timePerLoss_ = 0;
  bool hasNoise_ = false;
  SonarLinkSettings link_;
  Random* random_ = nullptr;
  /// In the order in which they were sent.
  std::vector<Wave> underWay_;
  std::size_t bytesUnderWay_ = 0;
  /// By address.
  std::map<std::string, Time> deafUntil_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::AcousticComms, "gz::sim::systems::AcousticComms",
                      "ignition::gazebo::systems::AcousticComms");
