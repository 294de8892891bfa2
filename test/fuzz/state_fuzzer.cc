// Arbitrary changes of a saved state with a checksum that is right. It must be refused, and then nothing has changed,
// or be restored, and then the world goes on.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/control/differential_odometry.hh"
#include "pongsim/control/pid.hh"
#include "pongsim/control/speed_limiter.hh"
#include "pongsim/parameters.hh"
#include "pongsim/simulation.hh"
#include "pongsim/system.hh"
#include "require.hh"
#include "support/sim/forged_state.hh"

namespace {

using Bytes = std::vector<std::byte>;

constexpr const char* kWorld = R"(<sdf version="1.9"><world name="w">
  <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane/></geometry></collision>
  </link></model>
  <model name="crate"><pose>0 0 0.5 0 0 0</pose><link name="l"><collision name="c"><geometry><box><size>1 1 1</size></box>
  </geometry></collision></link></model>
  <model name="far"><pose>90 0 0.5 0 0 0</pose><link name="l"/></model>
  <model name="arm"><pose>3 0 1 0 0 0</pose><link name="base"/><link name="rod"><pose>0 0 0.5 0 0 0</pose></link>
    <joint name="fix" type="fixed"><parent>world</parent><child>base</child></joint>
    <joint name="hinge" type="revolute"><parent>base</parent><child>rod</child><axis><xyz>0 1 0</xyz></axis></joint>
  </model>
  <plugin name="gz::sim" filename="dummy">
    <performer name="p"><ref>crate</ref><geometry><box><size>1 1 1</size></box></geometry></performer>
    <level name="away"><pose>90 0 0 0 0 0</pose><geometry><box><size>9 9 9</size></box></geometry><ref>far</ref></level>
  </plugin></world></sdf>)";

/// Remembers what systems remember.
class Remembers final : public pongsim::System {
 public:
  void declare(pongsim::Declaration&) override {}
  void configure(const pongsim::SystemContext&) override {}
  void postUpdate(const pongsim::StepInfo& info) override {
    const double seconds = pongsim::toSeconds(info.time);
    odometry_.update(random_.uniform(), random_.normal(seconds, 1), 0.001);
    heard_.push_back(pid_.update(limiter_.limit(seconds, 0.001), 0.001));
    if (heard_.size() > 3 || schedule_.isDue(info.time)) heard_.clear();
  }
  void transfer(pongsim::StateArchive& archive) override {
    archive(odometry_);
    archive(random_);
    archive(limiter_);
    archive(pid_);
    archive(schedule_);
    archive(heard_);
    archive(name_);
  }

 private:
  pongsim::DifferentialOdometry odometry_{1, 0.1};
  pongsim::Random random_{1, "fuzz"};
  pongsim::SpeedLimiter limiter_;
  pongsim::Pid pid_;
  pongsim::Schedule schedule_{pongsim::Time(5'000'000)};
  std::vector<double> heard_;
  std::string name_ = "fuzz";
};

/// A world that has run, with a joint that was made meanwhile.
std::unique_ptr<pongsim::Simulation> begin() {
  pongsim::Diagnostics diagnostics;
  auto simulation =
      pongsim::Simulation::fromText(kWorld, "world.sdf", {.loadSystems = false, .levels = true}, diagnostics);
  simulation->addSystem("remembers", std::make_unique<Remembers>(), diagnostics);
  simulation->step(50);
  const pongsim::Link rod = *simulation->world().model("arm")->link("rod");
  const pongsim::Link crate = *simulation->world().model("crate")->link("l");
  pongsim::fuzz::require(static_cast<bool>(simulation->world().attach(rod, crate, "leash")));
  simulation->step(10);
  return simulation;
}

/// Applies changes of eleven bytes each: the place, the kind, and a value.
void change(Bytes& state, std::span<const std::byte> changes) {
  constexpr std::size_t kValue = 8, kChange = 3 + kValue;
  for (; changes.size() >= kChange; changes = changes.subspan(kChange)) {
    std::uint16_t number = 0;
    std::memcpy(&number, changes.data(), sizeof number);
    const std::span<const std::byte> value = changes.subspan(3, kValue);
    const std::size_t room = state.size() - pongsim::test::kStateHeader;
    if (room < kValue) return;
    const std::size_t place = pongsim::test::kStateHeader + number % (room - kValue + 1);
    const auto at = state.begin() + static_cast<std::ptrdiff_t>(place);
    switch (static_cast<unsigned>(changes[2]) % 4) {
      case 0:
        std::copy(value.begin(), value.end(), at);
        break;
      case 1:
        *at = value[0];
        break;
      case 2:
        state.resize(place);
        break;
      default:
        state.insert(at, value.begin(), value.end());
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using pongsim::fuzz::require;
  static const std::unique_ptr<pongsim::Simulation> simulation = begin();
  static const Bytes present = simulation->saveState();
  Bytes forged = present;
  change(forged, std::as_bytes(std::span(data, size)));
  const pongsim::Outcome<void> restored = simulation->restoreState(pongsim::test::withChecksum(std::move(forged)));
  if (restored) {
    try {
      simulation->step(20);
    } catch (const std::runtime_error&) {
      // it has exploded
    }
    require(static_cast<bool>(simulation->restoreState(present)));
  } else {
    require(!restored.error.empty());
  }
  require(simulation->saveState() == present);
  return 0;
}
