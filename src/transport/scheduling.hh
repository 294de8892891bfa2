#pragma once

namespace pongsim::transport {

/// While it lives, the calling thread, and for good the threads that it starts meanwhile, don't push away one that runs
/// when they wake (SCHED_BATCH, sched(7)): the simulation's thread, which publishes, is not to be held up by those that
/// carry what it publishes. Where the user has chosen another policy than the ordinary one, that stays.
class GivesWay {
 public:
  GivesWay();
  ~GivesWay();
  GivesWay(const GivesWay&) = delete;
  GivesWay& operator=(const GivesWay&) = delete;

 private:
  bool hasChanged_;
};

}  // namespace pongsim::transport
