// The library of Fortress's log systems; a world selects one by its class.
#include <array>
#include <memory>

#include "log/system/log_playback.hh"
#include "log/system/log_record.hh"
#include "pongsim/system.hh"

extern "C" PONGSIM_API const ::pongsim::SystemTable pongsim_systems;

namespace {

constexpr const char* kRecordNames[] = {"ignition::gazebo::systems::LogRecord", "gz::sim::systems::LogRecord"};
constexpr const char* kPlaybackNames[] = {"ignition::gazebo::systems::LogPlayback", "gz::sim::systems::LogPlayback"};

template <class Class>
pongsim::System* make() {
  return std::make_unique<Class>().release();
}

constexpr std::array<pongsim::SystemEntry, 2> kSystems{
    {{kRecordNames, make<pongsim::log::RecordSystem>}, {kPlaybackNames, make<pongsim::log::PlaybackSystem>}}};

}  // namespace

const ::pongsim::SystemTable pongsim_systems{::pongsim::kAbiVersion, kSystems};
