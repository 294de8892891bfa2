#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "pongsim/link_group.hh"
#include "pongsim/node.hh"
#include "pongsim/system.hh"
#include "web/frames/frame.hh"
#include "web/frames/roster.hh"
#include "web/server/session.hh"

namespace pongsim::web {

/// Where all links and actors of a world were at one time.
struct PoseSnapshot {
  FrameStatus status;
  std::shared_ptr<const Roster> roster;
  std::vector<Pose> X_WorldLinks;
  std::vector<Pose> X_WorldActors;
};

/// The channel on which the page hears where everything is (frame.hh). Each client gets what is now, when its socket
/// can take it. It may outlive the world.
class PoseChannel final : public OwnChannel, public Callee, public std::enable_shared_from_this<PoseChannel> {
 public:
  /// @param wake Has the world make a step soon, even where it is paused.
  PoseChannel(const std::string& world, std::function<void()> wake);

  std::string topic() const override { return topic_; }
  std::string schemaName() const override { return "pongsim.Frame"; }
  std::shared_ptr<void> open(const std::shared_ptr<Client>& client, std::uint64_t key,
                             std::function<std::string(std::uint64_t timeNs)> head) override;

  // For the simulation's thread.

  /// @return Whether somebody watches and it is time for the next frame; then not again until that is to be shown.
  bool takeIsWanted() { return isWanted_.load(std::memory_order_relaxed) && isWanted_.exchange(false); }
  /// Has all who watch get that, or what is newer. Wakes nobody, and costs the same for any number of them.
  void show(std::shared_ptr<const PoseSnapshot> snapshot);

  /// On the server's thread, regularly: has each client get what is new when its socket is free, and wants the next.
  void called() override;
  /// The world ends.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  struct Viewer;

  Frame frameFor(Viewer& viewer);

  const std::string topic_;
  std::atomic<bool> isWanted_ = false;
  std::mutex mutex_;
  std::function<void()> wake_;
  std::vector<std::shared_ptr<Viewer>> all_;
  std::shared_ptr<const PoseSnapshot> latest_;
  /// Whether the server's thread has not looked at the latest yet.
  bool isNew_ = false;
  // of the server's thread: while somebody watches, and the poses of a snapshot, for all who get it
  std::shared_ptr<void> regularly_;
  Clock::time_point next_{};
  std::shared_ptr<const PoseSnapshot> converted_;
  std::vector<FramePose> poses_;
};

/// Copies where everything is when a channel wants it, which looks at no clock otherwise. For the simulation's thread.
class PoseFeed {
 public:
  PoseFeed(const World& world, std::shared_ptr<PoseChannel> channel);
  ~PoseFeed();
  PoseFeed(const PoseFeed&) = delete;
  PoseFeed& operator=(const PoseFeed&) = delete;

  /// To be called after each step.
  void update(const StepInfo& step);
  /// Models, links or actors have come or gone.
  void worldChanged() { roster_.reset(); }

 private:
  using Clock = std::chrono::steady_clock;

  void take(const StepInfo& step);
  std::shared_ptr<PoseSnapshot> freeSnapshot();
  double realTimeFactor(const StepInfo& step, Clock::time_point now);

  World world_;
  std::shared_ptr<PoseChannel> channel_;
  std::shared_ptr<const Roster> roster_;
  std::optional<LinkGroup> group_;
  std::uint32_t revision_ = 0;
  std::vector<std::shared_ptr<PoseSnapshot>> pool_;
  /// Where the last half second of the pace began.
  Clock::time_point paceBegan_{};
  Time paceTime_{0};
  double pace_ = 0;
};

}  // namespace pongsim::web
