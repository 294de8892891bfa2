#include "cli/view/record_video.hh"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/view/camera_path.hh"
#include "cli/view/labels.hh"
#include "cli/view/video_file.hh"
#include "cli/view/viewpoint.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

/// Frames per second.
constexpr int kVideoRate = 25;

/// @return What the camera turns around: what it follows, what fills the picture, or everything.
Vector3 centreOf(const ViewOptions& options, Sight& sight) {
  std::string name = options.follow;
  if (name.empty() && !readViewpoint(options.camera)) name = options.camera;
  const Eigen::AlignedBox3d box = sight.bounds(name);
  if (!box.isEmpty()) return box.center();
  return name.empty() ? Vector3::Zero() : sight.position(name).value_or(Vector3::Zero());
}

}  // namespace

void drawPicture(const ViewOptions& options, Sight& sight, const PictureView& view, Painter& painter,
                 std::span<std::uint8_t> pixels) {
  painter.draw(sight, view, pixels);
  if (options.names) drawLabels(labelsOf(sight, view), options.width, options.height, pixels);
}

int recordVideo(const ViewOptions& options, Sight& sight, PictureView view) {
  const std::unique_ptr<VideoFile> file = VideoFile::begin(options, kVideoRate);
  if (file == nullptr) return kFailed;
  const auto frameAt = [](Time time) { return time.count() * kVideoRate / Time(std::chrono::seconds(1)).count(); };
  const std::int64_t end = std::max<std::int64_t>(frameAt(options.length), 1);
  Painter painter(options.kind);
  CameraPath path(sight, view.X_WorldEye, options.follow,
                  options.orbits ? std::optional(centreOf(options, sight)) : std::nullopt);
  std::vector<std::uint8_t> pixels(std::size_t{3} * options.width * options.height);
  std::int64_t count = 0;
  std::optional<Time> reached;
  for (std::int64_t frame = 0; frame < end; frame = std::max(frame + 1, frameAt(*reached))) {
    view.X_WorldEye = path.at(static_cast<double>(frame) / static_cast<double>(end));
    drawPicture(options, sight, view, painter, pixels);
    if (!file->add(frame, pixels)) return kFailed;
    ++count;
    reached = sight.advance(Time(std::chrono::seconds(frame + 1)) / kVideoRate);
    if (!reached) break;
  }
  if (!file->complete()) return kFailed;
  say(options.video + ": " + std::to_string(options.width) + " x " + std::to_string(options.height) + " pixels, " +
      std::to_string(count) + " pictures");
  if (const std::string legend = painter.legend(); !legend.empty()) say(legend);
  return reached ? kDone : kFailed;
}

}  // namespace pongsim::cli
