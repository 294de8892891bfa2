#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/system.hh"
#include "web/server/session.hh"

namespace pongsim::web {

/// The channel on which pages without 3D graphics get pictures of a world, as its cameras would see it. A page asks for
/// each picture, with its viewpoint, once it has the one before: so slow connections have few of them and never old
/// ones. A message is a JPEG file, or a text that says why there is none.
///
/// A thread of the channel draws. The simulation's thread only brings the scene up to date, before a picture is drawn.
/// May outlive the world.
class PictureChannel final : public OwnChannel, public std::enable_shared_from_this<PictureChannel> {
 public:
  /// @param wake Makes the world step soon, even if it is paused.
  PictureChannel(const std::string& world, std::function<void()> wake);
  ~PictureChannel() override;
  PictureChannel(const PictureChannel&) = delete;
  PictureChannel& operator=(const PictureChannel&) = delete;

  std::string topic() const override { return topic_; }
  std::string schemaName() const override { return "pongsim.Picture"; }
  std::shared_ptr<void> open(const std::shared_ptr<Client>& client, std::uint64_t key,
                             std::function<std::string(std::uint64_t timeNs)> head) override;
  /// Wants one picture (`readPictureWish`): the next one that differs from the client's last.
  std::string ask(const std::shared_ptr<void>& opened, const nlohmann::json& wish) override;

  // For the simulation's thread.

  /// Call after each step: brings the scene up to date if a picture is due, else it only reads a flag.
  void update(const World& world, const StepInfo& step) {
    if (isSceneWanted_.load(std::memory_order_acquire)) updateScene(world, step);
  }
  /// Call when the world ends.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  struct Viewer;
  struct Order;

  void updateScene(const World& world, const StepInfo& step);
  void run();
  void dropScene(std::unique_lock<std::mutex>& lock);
  Clock::time_point nextDue() const;
  std::vector<Order> takeDue();
  void draw(const Order& order);
  void send(const Order& order, const std::string& content, std::optional<std::size_t> hash);

  const std::string topic_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> wake_;
  bool isEnded_ = false;
  std::vector<std::shared_ptr<Viewer>> viewers_;
  /// After a picture, the thread rests for as long as it took.
  Clock::time_point rest_{};
  /// While set, the scene and what follows it belong to the simulation's thread, else to the channel's.
  std::atomic<bool> isSceneWanted_ = false;
  std::unique_ptr<CameraScene> scene_;
  std::uint64_t timeNs_ = 0;
  /// Why there is no scene.
  std::string problem_;
  /// Of the channel's thread.
  std::vector<std::uint8_t> pixels_;
  std::thread thread_;
};

}  // namespace pongsim::web
