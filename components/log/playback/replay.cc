#include "log/playback/replay.hh"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <unordered_set>
#include <utility>

#include "log/playback/model_text.hh"
#include "log/store/failure.hh"
#include "pongsim/scene.hh"

namespace pongsim::log {

Replay::Replay(const TlogReader& reader, const PlayedFiles& files, const SystemContext& context)
    : reader_(reader),
      files_(files),
      world_(context.world),
      edits_(context.edits),
      log_(context.log),
      player_(Scene(context.world)) {
  for (const char* type : {"ignition.msgs.SerializedStateMap", "ignition.msgs.SerializedState"})
    std::ranges::move(reader.topicsOf(type), std::back_inserter(topics_));
  if (!topics_.empty()) range_ = reader.timeRange();
}

void Replay::goTo(Time time) {
  std::int64_t from = std::numeric_limits<std::int64_t>::min();
  if (readTo_ && *readTo_ <= time.count()) {
    from = *readTo_ + 1;
  } else {
    state_.clear();
    lastAxes_.clear();
    isMatched_ = false;
  }
  // the first state applies from the start
  const std::int64_t to = std::max(time.count(), range_->first);
  std::size_t unread = 0;
  reader_.forEach({from, to, topics_}, [&](const Record& record) {
    if (!state_.apply(record.type, record.payload)) ++unread;
    return true;
  });
  readTo_ = to;
  if (unread > 0) log_.warning(std::to_string(unread) + " states of the recording can't be read and are skipped");
  if (state_.takeNews()) editModels();
}

/// Requests the insertion and removal of top-level models.
void Replay::editModels() {
  isMatched_ = false;
  std::set<std::string> recorded;
  for (const std::uint64_t world : state_.entitiesWith("World")) {
    for (const std::uint64_t model : state_.childrenWith(world, "Model")) {
      const std::string name = state_.text(model, "Name");
      recorded.insert(name);
      if (world_.model(name)) continue;
      try {
        edits_.insertText(modelText(state_, model, files_), "recorded model '" + name + "'", {},
                          [this, name](const Outcome<Model>& made) {
                            // no warning if an earlier request has created it
                            if (!made && !world_.model(name))
                              log_.warning("model '" + name + "' can't be created: " + made.error);
                          });
      } catch (const Failure& why) {
        log_.warning("model '" + name + "' is left out: " + why.what());
      }
    }
  }
  // a damaged log without a world does not remove all models
  if (recorded.empty()) return;
  for (const Model& model : world_.models()) {
    if (!recorded.contains(std::string(model.name()))) edits_.remove(model);
  }
}

/// Matches the recording's entities with the world's.
void Replay::match() {
  links_.clear();
  joints_.clear();
  for (const std::uint64_t id : state_.entitiesWith("Model")) {
    const std::optional<Model> model = world_.model(state_.scopedName(id));
    if (!model) continue;
    for (const std::uint64_t link : state_.childrenWith(id, "Link")) {
      if (const auto found = model->link(state_.text(link, "Name"))) links_.emplace(link, *found);
    }
    for (const std::uint64_t joint : state_.childrenWith(id, "Joint")) {
      if (const auto found = model->joint(state_.text(joint, "Name"))) joints_.emplace(joint, *found);
    }
  }
  isMatched_ = true;
}

Pose Replay::poseInWorld(std::uint64_t entity) const {
  Pose pose = state_.poseOf(entity);
  int depth = 0;
  for (std::uint64_t parent = state_.parentOf(entity); state_.find(parent, "Model") != nullptr && depth < 100;
       ++depth) {
    pose = state_.poseOf(parent) * pose;
    parent = state_.parentOf(parent);
  }
  return pose;
}

void Replay::place() {
  std::unordered_set<std::uint64_t> changed = state_.takeChanged();
  const Time time = player_.time();
  if (!isMatched_) {
    match();
    for (const auto& [id, link] : links_) changed.insert(id);
    for (const auto& [id, joint] : joints_) changed.insert(id);
  }
  bool hasModel = false;
  for (const std::uint64_t id : changed) hasModel = hasModel || state_.find(id, "Model") != nullptr;
  const auto isWithinChanged = [&](std::uint64_t link) {
    if (changed.contains(link)) return true;
    int depth = 0;
    for (std::uint64_t parent = hasModel ? state_.parentOf(link) : 0; parent != 0 && depth < 100; ++depth) {
      if (changed.contains(parent)) return true;
      parent = state_.parentOf(parent);
    }
    return false;
  };
  for (const auto& [id, link] : links_) {
    if (isWithinChanged(id) && link.exists()) player_.place(link, poseInWorld(id));
  }
  for (const std::uint64_t id : changed) placeJoint(id, time);
}

void Replay::placeJoint(std::uint64_t id, Time time) {
  const auto joint = joints_.find(id);
  if (joint == joints_.end() || !joint->second.exists()) return;
  const std::vector<double> positions = state_.numbersOf(id, "JointPosition");
  const std::vector<double> velocities = state_.numbersOf(id, "JointVelocity");
  Axes& last = lastAxes_[id];
  const double passed = toSeconds(time - last.time);
  for (std::size_t axis = 0; axis < positions.size() && axis < 2; ++axis) {
    double velocity = 0;
    if (axis < velocities.size()) {
      velocity = velocities[axis];
    } else if (axis < last.positions.size() && passed > 0) {
      velocity = (positions[axis] - last.positions[axis]) / passed;
    }
    player_.setAxis(joint->second, static_cast<int>(axis), positions[axis], velocity);
  }
  last = {positions, time};
}

}  // namespace pongsim::log
