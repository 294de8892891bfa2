#pragma once

#include <ignition/msgs/scene.pb.h>

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "web/typed/frames.hh"
#include "web/world/world_link.hh"

namespace pongsim::web::typed {

/// A world's scene, requested again whenever models or lights are added or removed. For any thread.
class WorldScene : public std::enable_shared_from_this<WorldScene> {
 public:
  struct State {
    explicit State(const ignition::msgs::Scene& all) : scene(all), frames(all) {}
    ignition::msgs::Scene scene;
    Frames frames;
  };

  /// Do not destroy it on the world's thread.
  static std::shared_ptr<WorldScene> open(std::shared_ptr<WorldLink> world);
  explicit WorldScene(std::shared_ptr<WorldLink> world) : world_(std::move(world)) {}

  /// @return The latest scene; null before the first.
  std::shared_ptr<const State> state() const;

  /// @param changed Called on the world's thread when there is a new scene; must be fast, and must not end watches.
  std::shared_ptr<void> watch(std::function<void()> changed);

  /// @return The service that provides it.
  static OwnService serviceOf(const std::string& world);

 private:
  std::vector<std::shared_ptr<void>> listen();
  void ask();
  void answered(const CallResult& result, const Message& reply);

  const std::shared_ptr<WorldLink> world_;
  mutable std::mutex mutex_;
  std::shared_ptr<const State> state_;
  bool isAsking_ = false;
  /// Whether something has changed since the request.
  bool isOld_ = false;
  std::vector<std::shared_ptr<const std::function<void()>>> watches_;
  /// Used on the world's thread.
  bool hasWarned_ = false;
};

}  // namespace pongsim::web::typed
