#include "web/frames/pose_feed.hh"

#include <algorithm>
#include <utility>

#include "pongsim/scene.hh"

namespace pongsim::web {

namespace {

constexpr std::chrono::nanoseconds kPeriod{1'000'000'000 / 60};
constexpr std::chrono::milliseconds kPaceWindow{500};
// the shortest time between two readings of the scene because of colours: lights may blink
constexpr std::chrono::seconds kColorPeriod{1};
// The feed writes one, the channel has the latest, the server's thread reads one, and one is spare.
constexpr std::size_t kPool = 4;

}  // namespace

struct PoseChannel::Viewer {
  std::shared_ptr<Client> client;
  std::uint64_t key = 0;
  std::function<std::string(std::uint64_t)> head;
  // for the server's thread: its latest snapshot
  std::vector<FramePose> before;
  std::optional<FrameStatus> status;
};

PoseChannel::PoseChannel(const std::string& world, std::function<void()> wake)
    : topic_("/world/" + world + "/frame"), wake_(std::move(wake)) {}

std::shared_ptr<void> PoseChannel::open(const std::shared_ptr<Client>& client, std::uint64_t key,
                                        std::function<std::string(std::uint64_t timeNs)> head) {
  auto viewer = std::make_shared<Viewer>();
  viewer->client = client;
  viewer->key = key;
  viewer->head = std::move(head);
  {
    const std::lock_guard lock(mutex_);
    all_.push_back(viewer);
    if (!regularly_) {
      regularly_ = client->callRegularly(weak_from_this());
      // a snapshot made for earlier viewers is outdated
      isNew_ = false;
    }
    // a new client gets a frame at once, even if the world is paused
    isWanted_ = true;
    if (wake_) wake_();
  }
  return {nullptr, [self = shared_from_this(), viewer](void*) {
            const std::lock_guard lock(self->mutex_);
            std::erase(self->all_, viewer);
            if (self->all_.empty()) {
              self->regularly_.reset();
              self->isWanted_ = false;
            }
            viewer->client->forget(viewer->key);
          }};
}

void PoseChannel::show(std::shared_ptr<const PoseSnapshot> snapshot) {
  const std::lock_guard lock(mutex_);
  latest_.swap(snapshot);
  isNew_ = true;
}

void PoseChannel::called() {
  const Clock::time_point now = Clock::now();
  const std::lock_guard lock(mutex_);
  if (now >= next_ && !all_.empty()) {
    // missed frames are skipped
    next_ = std::max(next_ + kPeriod, now + kPeriod / 2);
    isWanted_ = true;
  }
  if (!std::exchange(isNew_, false)) return;
  for (const std::shared_ptr<Viewer>& viewer : all_) {
    // weak, because the viewer owns the client, which owns this function
    viewer->client->sendWhenFree(viewer->key, [self = shared_from_this(), waiting = std::weak_ptr(viewer)] {
      const std::shared_ptr<Viewer> there = waiting.lock();
      return there ? self->frameFor(*there) : Frame{};
    });
  }
}

Frame PoseChannel::frameFor(Viewer& viewer) {
  std::shared_ptr<const PoseSnapshot> snapshot;
  {
    const std::lock_guard lock(mutex_);
    snapshot = latest_;
  }
  if (!snapshot) return {};
  if (snapshot != converted_) {
    snapshot->roster->poses(snapshot->X_WorldLinks, snapshot->X_WorldActors, poses_);
    converted_ = snapshot;
  }
  const bool isSameMoment = viewer.status == snapshot->status;
  if (viewer.status && viewer.status->revision != snapshot->status.revision) viewer.before.clear();
  viewer.status = snapshot->status;
  Payload body = encodeFrame(snapshot->status, poses_, viewer.before);
  // of a paused world, the same moment may have other poses: somebody has moved a model
  if (isSameMoment && body.size() == kFrameHead) return {};
  return {.head = viewer.head(snapshot->status.timeNs), .body = std::move(body)};
}

void PoseChannel::end() {
  const std::lock_guard lock(mutex_);
  wake_ = {};
}

PoseFeed::PoseFeed(const World& world, std::shared_ptr<PoseChannel> channel)
    : world_(world), channel_(std::move(channel)) {}

PoseFeed::~PoseFeed() { channel_->end(); }

void PoseFeed::update(const StepInfo& step) {
  if (channel_->takeIsWanted()) take(step);
}

void PoseFeed::take(const StepInfo& step) {
  if (!roster_) {
    roster_ = std::make_shared<const Roster>(world_);
    group_.emplace(world_, roster_->links());
    ++revision_;
  }
  tellOfColors(Clock::now());
  std::shared_ptr<PoseSnapshot> snapshot = freeSnapshot();
  snapshot->status = {.timeNs = static_cast<std::uint64_t>(step.time.count()),
                      .iterations = step.iteration,
                      .realTimeFactor = realTimeFactor(step, Clock::now()),
                      .isPaused = step.paused,
                      .revision = revision_};
  if (snapshot->roster != roster_) snapshot->roster = roster_;
  snapshot->X_WorldLinks.resize(group_->size());
  group_->copyPoses(snapshot->X_WorldLinks);
  snapshot->X_WorldActors.clear();
  for (const Actor& actor : roster_->actors()) snapshot->X_WorldActors.push_back(actor.pose());
  channel_->show(std::move(snapshot));
}

void PoseFeed::tellOfColors(Clock::time_point now) {
  const std::uint64_t changes = Scene(world_).colorChanges();
  if (changes == colorChanges_ || now - colorsTold_ < kColorPeriod) return;
  colorChanges_ = changes;
  colorsTold_ = now;
  ++revision_;
}

std::shared_ptr<PoseSnapshot> PoseFeed::freeSnapshot() {
  for (const std::shared_ptr<PoseSnapshot>& each : pool_) {
    if (each.use_count() > 1) continue;
      // use_count() loads relaxed: the fence orders the last reader's reads before our writes
#ifndef __SANITIZE_THREAD__  // ThreadSanitizer does not support fences
    std::atomic_thread_fence(std::memory_order_acquire);
#endif
    return each;
  }
  auto snapshot = std::make_shared<PoseSnapshot>();
  if (pool_.size() < kPool) pool_.push_back(snapshot);
  return snapshot;
}

double PoseFeed::realTimeFactor(const StepInfo& step, Clock::time_point now) {
  const auto wall = now - paceBegan_;
  if (wall >= kPaceWindow) {
    // the first window, and the first after a break, has no start to compare with
    const bool isKnown = wall < 2 * kPaceWindow && step.time >= paceTime_;
    pace_ = isKnown ? toSeconds(step.time - paceTime_) / std::chrono::duration<double>(wall).count() : pace_;
    paceBegan_ = now;
    paceTime_ = step.time;
  }
  return step.paused ? 0 : pace_;
}

}  // namespace pongsim::web
