// The system that records a camera into a video file, on request of a service.

#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/time.pb.h>
#include <ignition/msgs/video_record.pb.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/system.hh"
#include "video/encoder.hh"
#include "video/frame_clock.hh"
#include "video/output_file.hh"
#include "video/recording.hh"

namespace pongsim::video {

namespace {

using ignition::msgs::Boolean;
using ignition::msgs::Image;
using ignition::msgs::VideoRecord;

constexpr int kHighestRate = 1000;
constexpr int kLowestBitrate = 1000;
constexpr int kHighestBitrate = 1'000'000'000;

/// Fortress's names of images and their pixels.
std::optional<std::pair<ignition::msgs::PixelFormatType, Pixels>> pixelsOf(PixelFormat format) {
  switch (format) {
    case PixelFormat::kR8G8B8:
      return {{ignition::msgs::RGB_INT8, Pixels::kRgb}};
    case PixelFormat::kB8G8R8:
      return {{ignition::msgs::BGR_INT8, Pixels::kBgr}};
    case PixelFormat::kL8:
      return {{ignition::msgs::L_INT8, Pixels::kGrey}};
    case PixelFormat::kL16:
      return {{ignition::msgs::L_INT16, Pixels::kGrey16}};
    default:
      return std::nullopt;
  }
}

/// @return "/world/W/model/M/link/L/sensor/S", whatever the sensor's `<topic>`.
std::string scopedTopic(const World& world, const Sensor& sensor) {
  std::string topic = "/" + sensor.scopedName();
  const auto putBeforeLast = [&topic](const std::string& separator, const std::string& kind) {
    const std::size_t at = topic.rfind(separator);
    topic.replace(at, separator.size(), kind);
  };
  putBeforeLast("::", "/sensor/");
  putBeforeLast("::", "/link/");
  while (topic.find("::") != std::string::npos) putBeforeLast("::", "/model/");
  return "/world/" + std::string(world.name()) + "/model" + topic;
}

/// @return The value of a key in a message's header; empty if there is none.
std::string headerValue(const Image& image, const std::string& key) {
  for (const auto& entry : image.header().data()) {
    if (entry.key() == key && entry.value_size() > 0) return entry.value(0);
  }
  return {};
}

Time stampOf(const Image& image) {
  const auto& stamp = image.header().stamp();
  return std::chrono::seconds(stamp.sec()) + std::chrono::nanoseconds(stamp.nsec());
}

/// @return "2026-11-27T21:23:43", of this place's clock.
std::string nowInIso() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::localtime_r(&now, &parts);
  std::string text(32, '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &parts));
  return text;
}

/// Records a camera's images into a video while it is told to.
class CameraVideoRecorder final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Records a camera's images as a video. Its `<plugin>` is in the `<sensor>` of a camera.",
                   Declaration::Place::kModel);
    declaration.usesFiles();
    declaration.standsOutside();
    declaration.parameter("sensor", &sensorName_, "", "the camera, LINK::SENSOR; in a `<sensor>` this is set by itself")
        .required();
    declaration.parameter("service", &serviceName_, "", "service that starts and stops a recording")
        .otherwise("/world/W/model/M/link/L/sensor/S/record_video");
    declaration.parameter("use_sim_time", &usesSimTime_, "", "show images for their simulated time, not the wall time");
    declaration.parameter("fps", &settings_.rate, "1/s", "frames of the video per second, at most")
        .atLeast(1)
        .atMost(kHighestRate);
    declaration.parameter("bitrate", &settings_.bitrate, "bit/s", "of the video")
        .atLeast(kLowestBitrate)
        .atMost(kHighestBitrate);
    declaration.parameter("folder", &folder_, "", "where videos may be written, also below it")
        .otherwise("the current folder");
    declaration.serves("/world/W/model/M/link/L/sensor/S/record_video", "ignition.msgs.VideoRecord",
                       "ignition.msgs.Boolean", "starts or stops a recording");
    declaration.publishes("/world/W/model/M/link/L/sensor/S/image/stats", "ignition.msgs.Time",
                          "length of the video with each of its frames; below the camera's topic");
  }

  void configure(const SystemContext& context) override {
    log_ = &context.log;
    node_ = &context.node;
    findCamera(context);
    const auto* camera = sensor_->settings<CameraSettings>();
    const auto pixels = pixelsOf(camera->format);
    if (!pixels) refuse(context.sdf, "the camera's <format> can't be recorded");
    format_ = pixels->first;
    settings_.pixels = pixels->second;
    settings_.width = static_cast<int>(camera->width);
    settings_.height = static_cast<int>(camera->height);
    topic_ = cleanTopic(sensor_->topic("/image"));
    name_ = sensor_->scopedName();
    frame_ = sensor_->frameName();
    if (folder_.empty()) folder_ = ".";
    // where the run was started, also if the process goes elsewhere
    folder_ = std::filesystem::absolute(folder_).string();
    stats_ = node_->advertise<ignition::msgs::Time>(topic_ + "/stats");
    service_ = node_->serve<VideoRecord, Boolean>(
        topicOr(serviceName_, scopedTopic(context.world, *sensor_) + "/record_video"),
        [this](const VideoRecord& request, Boolean& reply) {
          const Outcome<void> done = request.start() && !request.stop() ? start(request) : stop();
          reply.set_data(static_cast<bool>(done));
          return done ? ServiceAnswer(true) : ServiceAnswer::refused(done.error);
        });
  }

  void postUpdate(const StepInfo&) override {
    // not where its own function ended the recording
    if (!recording_) images_ = {};
  }

  void finish() override {
    stop();
    if (!firstFailure_.empty()) throw std::runtime_error(firstFailure_);
  }

 private:
  void findCamera(const SystemContext& context) {
    const std::string wanted = context.model->scopedName() + "::" + sensorName_;
    for (const char* type : {"camera", "wideanglecamera", "wide_angle_camera"}) {
      for (const Sensor& each : context.world.sensors(type)) {
        if (each.scopedName() == wanted) sensor_ = each;
      }
    }
    if (!sensor_)
      refuse(context.sdf, "'" + sensorName_ + "' is no camera of the model", "it records colour cameras only");
  }

  Outcome<void> start(const VideoRecord& request) {
    if (recording_) return {"it already records '" + recording_->place().string() + "'"};
    VideoSettings settings = settings_;
    settings.format = request.format().empty() ? "mp4" : request.format();
    std::ranges::transform(settings.format, settings.format.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    if (!isVideoFormat(settings.format)) {
      return {"'" + request.format() + "' is no video format: there are mp4, ogv and avi"};
    }
    const std::string wanted = request.save_filename().empty()
                                   ? fileNameOf(name_) + "_" + nowInIso() + "." + settings.format
                                   : request.save_filename();
    Outcome<std::filesystem::path> place = placeOf(wanted, folder_, "." + settings.format);
    if (!place) return {place.error};
    Outcome<std::unique_ptr<Encoder>> encoder = Encoder::create(*place, settings);
    if (!encoder) return {encoder.error};
    failure_ = {};
    recording_ = std::make_unique<Recording>(std::move(*encoder));
    clock_.emplace(settings.rate);
    images_ = node_->subscribe<Image>(topic_, [this](const Image& image) { add(image); });
    log_->info("camera '" + name_ + "': recording into '" + place->string() + "'");
    return {};
  }

  void add(const Image& image) {
    if (!recording_ || !isMine(image)) return;
    const Time time = usesSimTime_ ? stampOf(image) : Time(std::chrono::steady_clock::now().time_since_epoch());
    const std::optional<std::int64_t> frame = clock_->frameOf(time);
    if (!frame) return;
    if (const Outcome<void> added = recording_->add(*frame, image.data()); !added) {
      fail(added);
      recording_.reset();
      return;
    }
    if (!stats_.hasSubscribers()) return;
    ignition::msgs::Time length;
    setTime(clock_->length(), length);
    stats_.publish(length);
  }

  /// @return Whether it is of this camera: others may publish on the same topic.
  bool isMine(const Image& image) const {
    return headerValue(image, "frame_id") == frame_ && image.pixel_format_type() == format_ &&
           image.width() == static_cast<unsigned>(settings_.width) &&
           image.height() == static_cast<unsigned>(settings_.height);
  }

  /// @return Why the video that was begun last is not complete.
  Outcome<void> stop() {
    if (!recording_) return failure_;
    const std::string place = recording_->place().string();
    Outcome<void> done = recording_->complete();
    images_ = {};
    recording_.reset();
    if (done) {
      log_->info("camera '" + name_ + "': '" + place + "' is complete");
    } else {
      fail(done);
    }
    return done;
  }

  void fail(const Outcome<void>& why) {
    failure_ = why;
    if (firstFailure_.empty()) firstFailure_ = why.error;
    log_->error("camera '" + name_ + "': " + why.error + "; the recording has ended");
  }

  std::string sensorName_, serviceName_, folder_;
  bool usesSimTime_ = false;
  VideoSettings settings_;
  ignition::msgs::PixelFormatType format_{};
  std::optional<Sensor> sensor_;
  std::string topic_, name_, frame_;
  const Logger* log_ = nullptr;
  Node* node_ = nullptr;
  Publisher stats_;
  Service service_;
  std::optional<FrameClock> clock_;
  /// Of the last recording.
  Outcome<void> failure_;
  /// Of all recordings.
  std::string firstFailure_;
  std::unique_ptr<Recording> recording_;
  Subscription images_;
};

}  // namespace

}  // namespace pongsim::video

PONGSIM_EXPORT_SYSTEM(pongsim::video::CameraVideoRecorder, "ignition::gazebo::systems::CameraVideoRecorder",
                      "gz::sim::systems::CameraVideoRecorder");
