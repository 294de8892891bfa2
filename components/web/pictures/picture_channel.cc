#include "web/pictures/picture_channel.hh"

#include <algorithm>
#include <exception>
#include <string_view>
#include <utility>

#include "web/pictures/jpeg.hh"
#include "web/pictures/picture_wish.hh"

namespace pongsim::web {

namespace {

// between two pictures of a client
constexpr std::chrono::milliseconds kPicturePeriod{100};
// until one that did not differ from the last is drawn again
constexpr std::chrono::milliseconds kStillPeriod{500};
// for each client [bytes/s]
constexpr double kMostBytes = 512e3;
constexpr int kQuality = 80;

}  // namespace

struct PictureChannel::Viewer {
  std::shared_ptr<Client> client;
  std::uint64_t key = 0;
  std::function<std::string(std::uint64_t)> head;
  std::optional<PictureView> wish;
  /// Number of wishes so far.
  std::uint64_t wishes = 0;
  /// When the wish is due, and the earliest time for a new one.
  Clock::time_point due{};
  Clock::time_point free{};
  /// Of the pixels of its last picture.
  std::optional<std::size_t> hash;
};

/// A picture to draw.
struct PictureChannel::Order {
  std::shared_ptr<Viewer> viewer;
  PictureView view;
  /// `Viewer::wishes` when it was taken: later ones are not fulfilled by it.
  std::uint64_t wish = 0;
};

PictureChannel::PictureChannel(const std::string& world, std::function<void()> wake)
    : topic_("/world/" + world + "/picture"), wake_(std::move(wake)) {}

PictureChannel::~PictureChannel() { end(); }

std::shared_ptr<void> PictureChannel::open(const std::shared_ptr<Client>& client, std::uint64_t key,
                                           std::function<std::string(std::uint64_t timeNs)> head) {
  auto viewer = std::make_shared<Viewer>();
  viewer->client = client;
  viewer->key = key;
  viewer->head = std::move(head);
  {
    const std::lock_guard lock(mutex_);
    viewers_.push_back(viewer);
  }
  return {viewer.get(), [self = shared_from_this(), viewer](void*) {
            {
              const std::lock_guard lock(self->mutex_);
              std::erase(self->viewers_, viewer);
            }
            self->changed_.notify_all();
            viewer->client->forget(viewer->key);
          }};
}

std::string PictureChannel::ask(const std::shared_ptr<void>& opened, const nlohmann::json& wish) {
  auto view = readPictureWish(wish);
  if (!view) return view.error;
  {
    const std::lock_guard lock(mutex_);
    if (isEnded_) return "the world has ended";
    auto& viewer = *static_cast<Viewer*>(opened.get());
    viewer.wish = *view;
    ++viewer.wishes;
    viewer.due = viewer.free;
    if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
  }
  changed_.notify_all();
  return {};
}

void PictureChannel::updateScene(const World& world, const StepInfo& step) {
  try {
    if (!scene_) {
      scene_ = std::make_unique<CameraScene>(world);
      scene_->setMarkerViewers(MarkerViewers::kPeople);
      // the page warns of files that are missing
      Diagnostics none;
      scene_->rebuild(none);
    }
    scene_->update();
    problem_.clear();
  } catch (const std::exception& error) {
    scene_.reset();
    problem_ = error.what();
  }
  timeNs_ = static_cast<std::uint64_t>(step.time.count());
  {
    const std::lock_guard lock(mutex_);
    isSceneWanted_.store(false, std::memory_order_release);
  }
  changed_.notify_all();
}

void PictureChannel::end() {
  {
    const std::lock_guard lock(mutex_);
    isEnded_ = true;
    wake_ = {};
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  scene_.reset();
}

void PictureChannel::run() {
  std::unique_lock lock(mutex_);
  while (!isEnded_) {
    if (viewers_.empty() && scene_) {
      dropScene(lock);
      // without the lock, what there is to do may have changed
      continue;
    }
    const Clock::time_point due = nextDue();
    if (due == Clock::time_point::max()) {
      changed_.wait(lock);
      continue;
    }
    if (due > Clock::now()) {
      changed_.wait_until(lock, due);
      continue;
    }
    isSceneWanted_.store(true, std::memory_order_release);
    if (wake_) wake_();
    changed_.wait(lock, [this] { return isEnded_ || !isSceneWanted_.load(std::memory_order_acquire); });
    if (isEnded_) return;
    const std::vector<Order> orders = takeDue();
    lock.unlock();
    const Clock::time_point begin = Clock::now();
    for (const Order& order : orders) draw(order);
    const Clock::time_point now = Clock::now();
    lock.lock();
    rest_ = now + (now - begin);
  }
}

/// Meshes and textures may be large.
void PictureChannel::dropScene(std::unique_lock<std::mutex>& lock) {
  lock.unlock();
  scene_.reset();
  pixels_ = {};
  lock.lock();
}

/// @return When the next picture is due; `max` if nobody wants one.
PictureChannel::Clock::time_point PictureChannel::nextDue() const {
  Clock::time_point due = Clock::time_point::max();
  for (const auto& viewer : viewers_) {
    if (viewer->wish) due = std::min(due, std::max(viewer->due, rest_));
  }
  return due;
}

std::vector<PictureChannel::Order> PictureChannel::takeDue() {
  std::vector<Order> orders;
  for (const auto& viewer : viewers_) {
    if (viewer->wish && viewer->due <= Clock::now()) orders.push_back({viewer, *viewer->wish, viewer->wishes});
  }
  return orders;
}

void PictureChannel::draw(const Order& order) {
  try {
    if (!scene_) return send(order, problem_, std::nullopt);
    const PictureView& view = order.view;
    pixels_.resize(std::size_t{3} * view.width * view.height);
    scene_->drawColors(view, pixels_);
    const std::string_view bytes(reinterpret_cast<const char*>(pixels_.data()), pixels_.size());
    const std::size_t hash = std::hash<std::string_view>()(bytes);
    {
      const std::lock_guard lock(mutex_);
      if (order.viewer->hash == hash) {
        if (order.viewer->wishes == order.wish) order.viewer->due = Clock::now() + kStillPeriod;
        return;
      }
    }
    send(order, jpegOf(pixels_, view.width, view.height, kQuality), hash);
  } catch (const std::exception& error) {
    send(order, error.what(), std::nullopt);
  }
}

void PictureChannel::send(const Order& order, const std::string& content, std::optional<std::size_t> hash) {
  const std::lock_guard lock(mutex_);
  Viewer& viewer = *order.viewer;
  if (std::ranges::find(viewers_, order.viewer) == viewers_.end()) return;
  viewer.client->sendData(viewer.key, 1, {viewer.head(timeNs_), Payload(content)});
  viewer.hash = hash;
  if (viewer.wishes == order.wish) viewer.wish.reset();
  const std::chrono::duration<double> ofBytes(static_cast<double>(content.size()) / kMostBytes);
  viewer.due = viewer.free =
      Clock::now() + std::max<Clock::duration>(kPicturePeriod, std::chrono::duration_cast<Clock::duration>(ofBytes));
}

}  // namespace pongsim::web
