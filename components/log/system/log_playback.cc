#include "log/system/log_playback.hh"

#include <ignition/msgs/log_playback_stats.pb.h>
#include <ignition/msgs/world_control.pb.h>

#include <algorithm>

#include "log/store/failure.hh"
#include "log/system/leave_out.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/scene.hh"

namespace pongsim::log {

void PlaybackSystem::declare(Declaration& declaration) {
  declaration.is("Plays a recording: everything moves as LogRecord recorded it, in a world without physics.",
                 Declaration::Place::kWorld);
  declaration.usesFiles();
  declaration.parameter("playback_path", &path_, "", "folder of the recording, zip file of one, or .tlog file")
      .required();
  declaration.publishes("/world/W/playback/stats", "ignition.msgs.LogPlaybackStatistics",
                        "the times of the recording's first and last state, once, latched");
}

void PlaybackSystem::configure(const SystemContext& context) {
  log_ = &context.log;
  node_ = context.node;
  const std::string world = "/world/" + std::string(context.world.name());
  controlService_ = cleanTopic(world + "/control");
  const bool isSecond = std::ranges::any_of(
      context.before, [](System* other) { return dynamic_cast<PlaybackSystem*>(other) != nullptr; });
  if (isSecond) refuse(context.sdf, "a recording is already being played", "remove one of the two LogPlayback systems");
  try {
    open(context);
  } catch (const Failure& why) {
    leaveOut(context, why.what(), why.hint());
  }
  range_ = context.node.advertise<ignition::msgs::LogPlaybackStatistics>(cleanTopic(world + "/playback/stats"),
                                                                         {.latched = true});
  publishRange();
}

void PlaybackSystem::open(const SystemContext& context) {
  files_ = std::make_unique<PlayedFiles>(path_);
  reader_ = std::make_unique<TlogReader>(files_->stateFile());
  player_.emplace(Scene(context.world));
  replay_ = std::make_unique<Replay>(*reader_, *files_, context);
  if (!replay_->range()) throw Failure("'" + path_ + "' contains no state of a world");
  if (const auto torn = reader_->torn()) log_->warning(*torn);
  // for the first step
  goTo(player_->stepSize());
}

void PlaybackSystem::publishRange() {
  ignition::msgs::LogPlaybackStatistics statistics;
  setTime(Time(replay_->range()->first), *statistics.mutable_start_time());
  setTime(Time(replay_->range()->last), *statistics.mutable_end_time());
  range_.publish(statistics);
}

void PlaybackSystem::goTo(Time time) {
  at_ = time;
  replay_->goTo(time);
}

void PlaybackSystem::preUpdate(const StepInfo& info) {
  // the step size has changed, or the time was set
  if (!info.paused && info.time != at_) goTo(info.time);
  replay_->place();
}

void PlaybackSystem::postUpdate(const StepInfo& info) {
  if (info.paused) return;
  pauseAtEnd(info);
  // models of the next step are inserted and removed at the end of this one
  goTo(info.time + info.dt);
}

void PlaybackSystem::pauseAtEnd(const StepInfo& info) {
  if (info.time.count() < replay_->range()->last) return;
  ignition::msgs::WorldControl pause;
  pause.set_pause(true);
  pause_ = node_->request(controlService_, pause, "ignition.msgs.Boolean", {});
  // a warning, so that a run with more `--iterations` than the recording has explains why it waits
  log_->warning("end of the recording at " + std::to_string(toSeconds(info.time)) +
                " s; paused until it is rewound or stopped");
}

void PlaybackSystem::worldChanged() { replay_->worldChanged(); }

void PlaybackSystem::reset() { goTo(player_->time()); }

}  // namespace pongsim::log
