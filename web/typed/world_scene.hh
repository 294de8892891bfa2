#pragma once

#include <ignition/msgs/scene.pb.h>

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "web/typed/frames.hh"
#include "web/world/world_link.hh"

namespace pongsim::web::typed {

/// What is to be seen in a world, asked for anew whenever models or lights have come or gone. For any thread.
class WorldScene : public std::enable_shared_from_this<WorldScene> {
 public:
  struct State {
    explicit State(const ignition::msgs::Scene& all) : scene(all), frames(all) {}
    ignition::msgs::Scene scene;
    Frames frames;
  };

  /// Not to be let go of on the world's thread.
  static std::shared_ptr<WorldScene> open(std::shared_ptr<WorldLink> world);
  explicit WorldScene(std::shared_ptr<WorldLink> world) : world_(std::move(world)) {}

  /// @return The last answer; null where there has been none.
  std::shared_ptr<const State> state() const;

  /// @param changed Called on the world's thread when there is another state; must be quick, and must not end watches.
  std::shared_ptr<void> watch(std::function<void()> changed);

  /// @return Which service tells it.
  static OwnService serviceOf(const std::string& world);

 private:
  std::vector<std::shared_ptr<void>> listen();
  void ask();
  void answered(const CallResult& result, const Message& reply);

  const std::shared_ptr<WorldLink> world_;
  mutable std::mutex mutex_;
  std::shared_ptr<const State> state_;
  bool isAsking_ = false;
  /// Whether something has changed since it asked.
  bool isOld_ = false;
  std::vector<std::shared_ptr<const std::function<void()>>> watches_;
  /// Of the world's thread.
  bool hasWarned_ = false;
};

}  // namespace pongsim::web::typed
