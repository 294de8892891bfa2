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

/// Poses of all links and actors of a world at one time.
struct PoseSnapshot {
  FrameStatus status;
  std::shared_ptr<const Roster> roster;
  std::vector<Pose> X_WorldLinks;
  std::vector<Pose> X_WorldActors;
};

/// The channel on which the page receives all poses (frame.hh). Each client gets the current ones when its socket can
/// take them. May outlive the world.
class PoseChannel final : public OwnChannel, public Callee, public std::enable_shared_from_this<PoseChannel> {
 public:
  /// @param wake Makes the world step soon, even if it is paused.
  PoseChannel(const std::string& world, std::function<void()> wake);

  std::string topic() const override { return topic_; }
  std::string schemaName() const override { return "pongsim.Frame"; }
  std::shared_ptr<void> open(const std::shared_ptr<Client>& client, std::uint64_t key,
                             std::function<std::string(std::uint64_t timeNs)> head) override;
  std::string ask(const std::shared_ptr<void>&, const nlohmann::json&) override { return "poses come by themselves"; }

  // For the simulation's thread.

  /// @return Whether somebody is watching and the next frame is due; then false until that frame has been shown.
  bool takeIsWanted() { return isWanted_.load(std::memory_order_relaxed) && isWanted_.exchange(false); }
  /// Offers a snapshot to all viewers, who get this or a newer one. Wakes no thread, and costs the same for any
  /// number of viewers.
  void show(std::shared_ptr<const PoseSnapshot> snapshot);

  /// Called regularly on the server's thread: sends each client new poses when its socket is free, and asks for the
  /// next frame.
  void called() override;
  /// Call when the world ends.
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
  /// Whether the server's thread has yet to see the latest snapshot.
  bool isNew_ = false;
  // used on the server's thread: the regular call, while somebody watches, and a snapshot's poses, shared by all
  // viewers
  std::shared_ptr<void> regularly_;
  Clock::time_point next_{};
  std::shared_ptr<const PoseSnapshot> converted_;
  std::vector<FramePose> poses_;
};

/// Copies all poses when a channel asks for them; otherwise it does not even read a clock. For the simulation's thread.
class PoseFeed {
 public:
  PoseFeed(const World& world, std::shared_ptr<PoseChannel> channel);
  ~PoseFeed();
  PoseFeed(const PoseFeed&) = delete;
  PoseFeed& operator=(const PoseFeed&) = delete;

  /// Call after each step.
  void update(const StepInfo& step);
  /// Call when models, links or actors have been added or removed.
  void worldChanged() { roster_.reset(); }

 private:
  using Clock = std::chrono::steady_clock;

  void take(const StepInfo& step);
  std::shared_ptr<PoseSnapshot> freeSnapshot();
  double realTimeFactor(const StepInfo& step, Clock::time_point now);
  /// Lets pages read the scene again where visuals have other colours.
  void tellOfColors(Clock::time_point now);

  World world_;
  std::shared_ptr<PoseChannel> channel_;
  std::shared_ptr<const Roster> roster_;
  std::optional<LinkGroup> group_;
  std::uint32_t revision_ = 0;
  /// `Scene::colorChanges` that pages know of, and when they were told.
  std::uint64_t colorChanges_ = 0;
  Clock::time_point colorsTold_{};
  std::vector<std::shared_ptr<PoseSnapshot>> pool_;
  /// Start of the last half second over which the real-time factor is measured.
  Clock::time_point paceBegan_{};
  Time paceTime_{0};
  double pace_ = 0;
};

}  // namespace pongsim::web
