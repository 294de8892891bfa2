#pragma once

#include "pongsim/diagnostic.hh"
#include "pongsim/element.hh"
#include "pongsim/handles.hh"
#include "pongsim/node.hh"
#include "pongsim/system.hh"

namespace pongsim {

/// What the sensors of a kind share: what there is to be seen, and where to speak of it.
template <class SeenScene>
class Surroundings {
 public:
  Surroundings(const World& world, Node& node, const Element&) : scene_(world), node_(node) {}

  void observe(const StepInfo&) { isOfNow_ = false; }
  void rebuild(Diagnostics& diagnostics) {
    scene_.rebuild(diagnostics);
    isOfNow_ = false;
  }

  SeenScene& scene() { return scene_; }
  Node& node() { return node_; }
  /// @return The scene with everything where it is in this step.
  SeenScene& now() {
    if (!isOfNow_) scene_.update();
    isOfNow_ = true;
    return scene_;
  }

 private:
  SeenScene scene_;
  Node& node_;
  bool isOfNow_ = false;
};

}  // namespace pongsim
