#include "web/typed/world_scene.hh"

#include <ignition/msgs/empty.pb.h>

#include <utility>

#include "pongsim/log.hh"

namespace pongsim::web::typed {

std::shared_ptr<WorldScene> WorldScene::open(std::shared_ptr<WorldLink> world) {
  // the listeners separately: their callbacks hold the scene for a moment, and must not destroy it
  struct Listening {
    std::shared_ptr<WorldScene> scene;
    std::vector<std::shared_ptr<void>> ears;
  };
  const auto listening = std::make_shared<Listening>();
  listening->scene = std::make_shared<WorldScene>(std::move(world));
  listening->ears = listening->scene->listen();
  listening->scene->ask();
  return {listening, listening->scene.get()};
}

OwnService WorldScene::serviceOf(const std::string& world) {
  return {"/world/" + world + "/scene/info", "ignition.msgs.Empty", "ignition.msgs.Scene"};
}

std::vector<std::shared_ptr<void>> WorldScene::listen() {
  const auto ask = [self = weak_from_this()](const Payload&, std::uint64_t) {
    if (const auto scene = self.lock()) scene->ask();
  };
  const std::string prefix = "/world/" + world_->world() + "/scene/";
  return {world_->subscribe(prefix + "info", "ignition.msgs.Scene", {ask}),
          world_->subscribe(prefix + "deletion", "ignition.msgs.UInt32_V", {ask})};
}

std::shared_ptr<const WorldScene::State> WorldScene::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::shared_ptr<void> WorldScene::watch(std::function<void()> changed) {
  const auto shared = std::make_shared<const std::function<void()>>(std::move(changed));
  const std::lock_guard lock(mutex_);
  watches_.push_back(shared);
  return {this, [scene = shared_from_this(), shared](void*) {
            const std::lock_guard ending(scene->mutex_);
            std::erase(scene->watches_, shared);
          }};
}

void WorldScene::ask() {
  {
    const std::lock_guard lock(mutex_);
    isOld_ = isAsking_;
    if (std::exchange(isAsking_, true)) return;
  }
  world_->request(serviceOf(world_->world()), std::make_shared<ignition::msgs::Empty>(),
                  [self = weak_from_this()](const CallResult& result, const Message& reply) {
                    if (const auto scene = self.lock()) scene->answered(result, reply);
                  });
}

void WorldScene::answered(const CallResult& result, const Message& reply) {
  std::shared_ptr<const State> state;
  if (result) {
    state = std::make_shared<const State>(static_cast<const ignition::msgs::Scene&>(reply));
  } else if (!std::exchange(hasWarned_, true)) {
    Logger("web").warning("clients can't see the scene of world '" + world_->world() + "': " + result.error);
  }
  bool isOld = false;
  {
    const std::lock_guard lock(mutex_);
    isAsking_ = false;
    isOld = std::exchange(isOld_, false);
    if (state) {
      state_ = std::move(state);
      for (const auto& watch : watches_) (*watch)();
    }
  }
  // a refused request is not repeated
  if (isOld && result) ask();
}

}  // namespace pongsim::web::typed
