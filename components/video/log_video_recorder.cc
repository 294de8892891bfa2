// The system that records a video of each of several models, most often while a recording is played.

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/server_control.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/background_calls.hh"
#include "pongsim/math.hh"
#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/system.hh"
#include "video/encoder.hh"
#include "video/frame_clock.hh"
#include "video/output_file.hh"
#include "video/recording.hh"

namespace pongsim::video {

namespace {

constexpr int kLargestSide = 4096;
/// Horizontal, of the pictures.
constexpr double kFieldOfView = std::numbers::pi / 3;
/// From the model to the camera, in its largest extents; as Fortress's window follows a model, from -x and above.
constexpr double kDistance = 3;
const Vector3 kAway = Vector3(-5, 0, 3).normalized();
/// Extent of a model that is not visible [m].
constexpr double kNoExtent = 1;

/// The video of a model.
struct Film {
  std::string model;
  /// From the model's origin to the camera, in the world frame.
  Vector3 toCamera;
  PictureView view;
  FrameClock clock;
  std::unique_ptr<Recording> recording;
};

/// @return Three numbers in an element of a `<region>`.
Vector3 cornerIn(const Element& region, const char* name) {
  const Element* corner = region.child(name);
  if (corner == nullptr) refuse(region, "a <region> without <" + std::string(name) + ">");
  Vector3 place;
  Element holder;
  holder.children.push_back(*corner);
  Parameter(name, &place, "m", "").required().read(holder);
  return place;
}

/// Records what LogPlayback plays, or a world that moves by itself.
class LogVideoRecorder final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(
        "Records a video of each of some models, whose camera follows it, most often while LogPlayback plays a "
        "recording.",
        Declaration::Place::kWorld);
    declaration.usesFiles();
    declaration.standsOutside();
    declaration.parameter("entity", &entities_, "", "name of a model to record, E");
    declaration.element("region",
                        "a box with `<min>` and `<max>`, three numbers each [m]; repeated: records models "
                        "that are, or come, in one, too");
    declaration.parameter("start_time", &start_, "s", "when the videos begin").atLeast(0);
    declaration.parameter("end_time", &end_, "s", "when they end")
        .otherwise("when the recording or the run ends, or pauses");
    declaration.parameter("exit_on_finish", &endsRun_, "", "end the run when the videos are complete");
    declaration.parameter("width", &settings_.width, "pixels", "of the videos").atLeast(16).atMost(kLargestSide);
    declaration.parameter("height", &settings_.height, "pixels", "of the videos").atLeast(16).atMost(kLargestSide);
    declaration.parameter("fps", &settings_.rate, "1/s", "frames per simulated second").atLeast(1).atMost(1000);
    declaration.parameter("folder", &folder_, "", "where the videos E.mp4 are written").otherwise("the current folder");
    declaration.publishes("/log_video_recorder/status", "ignition.msgs.StringMsg",
                          "`end` when all videos are complete; latched");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    world_ = &context.world;
    node_ = context.node;
    for (const Element& child : context.sdf.children) {
      if (child.name == "region") regions_.emplace_back(cornerIn(child, "min"), cornerIn(child, "max"));
    }
    wanted_ = {entities_.begin(), entities_.end()};
    if (wanted_.empty() && regions_.empty()) refuse(context.sdf, "it has no <entity> and no <region>");
    if (end_ && *end_ < start_) refuse(context.sdf, "<end_time> is before <start_time>");
    if (end_) last_ = fromSeconds(*end_);
    if (folder_.empty()) folder_ = ".";
    // where the run was started, also if the process goes elsewhere
    folder_ = std::filesystem::absolute(folder_).string();
    status_ = node_->advertise<ignition::msgs::StringMsg>("/log_video_recorder/status", {.latched = true});
  }

  void worldChanged() override { isStale_ = true; }

  void postUpdate(const StepInfo& info) override {
    if (isDone_) return;
    if (info.paused) {
      // as in Fortress: a player pauses at the end of its recording
      if (!begun_.empty()) end();
      return;
    }
    lookIntoRegions();
    if (info.time < fromSeconds(start_)) return;
    begin();
    draw(info.time);
    if (info.time >= last_) end();
  }

  void finish() override {
    end();
    if (!firstFailure_.empty()) throw std::runtime_error(firstFailure_);
  }

 private:
  void lookIntoRegions() {
    if (regions_.empty()) return;
    for (const Model& model : world_->models()) {
      const Vector3 place = model.pose().position;
      const bool isIn = std::ranges::any_of(regions_, [&](const auto& region) { return region.contains(place); });
      std::string name(model.name());
      if (isIn && !begun_.contains(name)) wanted_.insert(std::move(name));
    }
  }

  /// Begins the videos of the wanted models that are there.
  void begin() {
    for (auto each = wanted_.begin(); each != wanted_.end();) {
      const std::optional<Model> model = world_->model(*each);
      if (!model) {
        ++each;
        continue;
      }
      if (const Outcome<void> filmed = film(*model, *each); !filmed) fail(*each, filmed.error);
      begun_.insert(*each);
      each = wanted_.erase(each);
    }
  }

  Outcome<void> film(const Model& model, const std::string& name) {
    if (const Outcome<void> seen = see(); !seen) return seen;
    Outcome<std::filesystem::path> place = placeOf(fileNameOf(name) + ".mp4", folder_, ".mp4");
    if (!place) return {place.error};
    Outcome<std::unique_ptr<Encoder>> encoder = Encoder::create(*place, settings_);
    if (!encoder) return {encoder.error};
    Eigen::AlignedBox3d box = scene_->bounds(model);
    const Vector3 origin = model.pose().position;
    if (box.isEmpty()) box.extend(origin);
    const double extent = box.sizes().maxCoeff() > 0 ? box.sizes().maxCoeff() : kNoExtent;
    Film added{name, box.center() - origin + kAway * kDistance * extent, {}, FrameClock(settings_.rate), nullptr};
    PictureView& view = added.view;
    view.width = static_cast<std::uint32_t>(settings_.width);
    view.height = static_cast<std::uint32_t>(settings_.height);
    view.fx = view.fy = settings_.width / (2 * std::tan(kFieldOfView / 2));
    view.cx = settings_.width / 2.0;
    view.cy = settings_.height / 2.0;
    view.near = extent / 100;
    view.far = std::numeric_limits<double>::infinity();
    view.X_WorldEye.rotation = fromRollPitchYaw(0, math::atan2(kAway.z(), -kAway.x()), 0);
    added.recording = std::make_unique<Recording>(std::move(*encoder));
    log_->info("recording '" + name + "' into '" + place->string() + "'");
    films_.push_back(std::move(added));
    return {};
  }

  /// Makes the scene what the world is now.
  Outcome<void> see() {
    try {
      if (!scene_) {
        scene_.emplace(*world_);
        isStale_ = true;
      }
      if (isStale_) {
        Diagnostics diagnostics;
        scene_->rebuild(diagnostics);
        for (const Diagnostic& each : diagnostics.all()) log_->warning(format(each));
        isStale_ = false;
      }
      scene_->update();
    } catch (const std::exception& error) {
      return {error.what()};
    }
    return {};
  }

  void draw(Time time) {
    bool isSeen = false;
    std::erase_if(films_, [&](Film& film) {
      const std::optional<std::int64_t> frame = film.clock.frameOf(time);
      if (!frame) return false;
      Outcome<void> drawn = isSeen ? Outcome<void>() : see();
      isSeen = true;
      if (drawn) drawn = shoot(film, *frame);
      if (!drawn) fail(film.model, drawn.error);
      return !drawn;
    });
  }

  Outcome<void> shoot(Film& film, std::int64_t frame) {
    // where the model is gone, the camera stays
    const std::optional<Model> model = world_->model(film.model);
    if (model) film.view.X_WorldEye.position = model->pose().position + film.toCamera;
    std::string pixels(std::size_t{3} * film.view.width * film.view.height, '\0');
    try {
      scene_->drawColors(film.view, {reinterpret_cast<std::uint8_t*>(pixels.data()), pixels.size()});
    } catch (const std::exception& error) {
      return {error.what()};
    }
    return film.recording->add(frame, std::move(pixels));
  }

  /// Completes all videos.
  void end() {
    if (isDone_) return;
    isDone_ = true;
    for (Film& film : films_) {
      const std::string place = film.recording->place().string();
      if (const Outcome<void> done = film.recording->complete(); !done) {
        fail(film.model, done.error);
      } else {
        log_->info("'" + place + "' is complete");
      }
    }
    films_.clear();
    scene_.reset();
    for (const std::string& name : wanted_) log_->warning("no video of '" + name + "': there has been no such model");
    ignition::msgs::StringMsg status;
    status.set_data("end");
    status_.publish(status);
    if (endsRun_) endRun();
  }

  void endRun() {
    auto stop = std::make_shared<ignition::msgs::ServerControl>();
    stop->set_stop(true);
    calls_.emplace(*node_, *log_);
    calls_->post({.service = "/server_control", .request = std::move(stop), .replyType = "ignition.msgs.Boolean"});
  }

  void fail(const std::string& model, const std::string& why) {
    const std::string text = "no video of '" + model + "': " + why;
    if (firstFailure_.empty()) firstFailure_ = text;
    log_->error(text);
  }

  std::vector<std::string> entities_;
  double start_ = 0;
  std::optional<double> end_;
  bool endsRun_ = false;
  VideoSettings settings_{.width = 640, .height = 480};
  std::string folder_;

  std::vector<Eigen::AlignedBox3d> regions_;
  /// Models whose videos have not begun, and others.
  std::set<std::string> wanted_, begun_;
  Time last_ = Time::max();
  const Logger* log_ = nullptr;
  World* world_ = nullptr;
  std::optional<Node> node_;
  Publisher status_;
  bool isStale_ = false;
  std::optional<CameraScene> scene_;
  std::vector<Film> films_;
  bool isDone_ = false;
  std::string firstFailure_;
  std::optional<BackgroundCalls> calls_;
};

}  // namespace

}  // namespace pongsim::video

PONGSIM_EXPORT_SYSTEM(pongsim::video::LogVideoRecorder, "ignition::gazebo::systems::LogVideoRecorder",
                      "gz::sim::systems::LogVideoRecorder");
