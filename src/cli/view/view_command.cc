#include <unistd.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/nearest_word.hh"
#include "cli/command.hh"
#include "cli/options/network_option.hh"
#include "cli/options/number_option.hh"
#include "cli/options/offline_option.hh"
#include "cli/options/renderer_option.hh"
#include "cli/options/secure_option.hh"
#include "cli/view/picture_plot.hh"
#include "cli/view/record_video.hh"
#include "cli/view/shrink.hh"
#include "cli/view/sixel.hh"
#include "cli/view/sixel_terminal.hh"
#include "cli/view/terminal_size.hh"
#include "cli/view/view_command.hh"
#include "cli/view/viewpoint.hh"
#include "pongsim/log.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

constexpr double kFieldOfView = std::numbers::pi / 3;
constexpr std::uint64_t kLongestViewEdge = 8192;
/// [s]
constexpr double kLongestVideo = 86'400;
/// Maximum edge length that terminals show; xterm's default.
constexpr int kMostSixels = 1000;
/// Time for a terminal to report its features.
constexpr std::chrono::milliseconds kTerminalPatience{500};

/// Parses "1280x720".
void readSize(const std::string& text, ViewOptions& options) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) throw UsageError("option '--size' takes WIDTHxHEIGHT, not '" + text + "'");
  const auto edge = [](const std::string& number) {
    return static_cast<std::uint32_t>(wholeNumber("--size", number, 1, kLongestViewEdge));
  };
  options.width = edge(text.substr(0, cross));
  options.height = edge(text.substr(cross + 1));
}

PictureView pinhole(const ViewOptions& options) {
  PictureView view;
  view.width = options.width;
  view.height = options.height;
  view.fx = view.fy = options.width / (2 * std::tan(kFieldOfView / 2));
  view.cx = options.width / 2.0;
  view.cy = options.height / 2.0;
  view.near = 0.01;
  view.far = INFINITY;
  view.showsGrid = options.grid;
  view.showsAxes = options.axes;
  return view;
}

/// @return The exit code, if there is no model or actor with that name.
std::optional<int> checkName(Sight& sight, const std::string& name, const std::string& advice) {
  const std::vector<std::string> names = sight.names();
  if (std::ranges::find(names, name) != names.end()) return std::nullopt;
  const std::string hint = base::didYouMean(name, std::vector<std::string_view>(names.begin(), names.end()));
  return fail("there is no model or actor '" + name + "' to look at", hint.empty() ? advice : hint);
}

/// Places the camera as the options say.
/// @return The exit code, if that is not possible.
std::optional<int> placeEye(Sight& sight, const ViewOptions& options, PictureView& view) {
  if (!options.follow.empty()) {
    if (const auto code = checkName(sight, options.follow, "--follow takes the name of a model or an actor"))
      return code;
  }
  if (const std::optional<Pose> pose = readViewpoint(options.camera)) {
    view.X_WorldEye = *pose;
    return std::nullopt;
  }
  if (!options.camera.empty()) {
    constexpr const char* kAdvice = "--camera takes the name of a model or an actor, or 'x y z roll pitch yaw'";
    if (const auto code = checkName(sight, options.camera, kAdvice)) return code;
  }
  Eigen::AlignedBox3d box = sight.bounds(options.camera.empty() ? options.follow : options.camera);
  if (box.isEmpty()) box = {Vector3(-1, -1, 0), Vector3(1, 1, 1)};
  lookAt(box, view);
  return std::nullopt;
}

/// @return The image as sixels, as large as the terminal allows.
std::string sixelPlot(const ViewOptions& options, const std::vector<std::uint8_t>& pixels, const TerminalSize& size) {
  const double columns = std::min(size.columns * size.letterWidth, kMostSixels);
  // leaves a row for the cursor below
  const double rows = std::min(std::max(1, size.rows - 1) * size.letterHeight, kMostSixels);
  const SmallPicture small = shrinkInto(pixels, options.width, options.height, columns, rows);
  return sixels(small.pixels, small.across, small.down) + "\n";
}

std::string terminalPlot(const ViewOptions& options, const std::vector<std::uint8_t>& pixels) {
  const TerminalSize size = terminalSize();
  if (options.sixel || knowsSixels(STDIN_FILENO, STDOUT_FILENO, kTerminalPatience)) {
    return sixelPlot(options, pixels, size);
  }
  return picturePlot(pixels, options.width, options.height, size.columns, std::max(1, size.rows - 1));
}

int show(const ViewOptions& options, const std::vector<std::uint8_t>& pixels) {
  if (options.terminal || options.sixel) {
    if (!print(terminalPlot(options, pixels))) return outputIsClosed() ? kDone : kFailed;
    if (options.output.empty()) return kDone;
  }
  const std::string file = options.output.empty() ? "view.png" : options.output;
  CameraScene::writePicture(file, options.width, options.height, pixels);
  say(file + ": " + std::to_string(options.width) + " x " + std::to_string(options.height) + " pixels");
  return kDone;
}

int viewWorld(const ViewOptions& options) {
  setLogLevel(LogLevel::kWarning);
  const std::unique_ptr<Sight> sight = options.file.empty() ? sightOfRunningWorld(options) : sightOfFile(options);
  if (sight == nullptr) return kFailed;
  PictureView view = pinhole(options);
  if (const auto code = placeEye(*sight, options, view)) return *code;
  if (!options.video.empty()) return recordVideo(options, *sight, view);
  std::vector<std::uint8_t> pixels(std::size_t{3} * options.width * options.height);
  Painter painter(options.kind);
  drawPicture(options, *sight, view, painter, pixels);
  if (const std::string legend = painter.legend(); !legend.empty()) say(legend);
  return show(options, pixels);
}

/// Options given for a file or for a running world.
struct ViewSource {
  std::optional<std::string> file, at, world, timeout, length;
  bool offline = false;
  bool depth = false, thermal = false, labels = false;
};

/// Sets what the picture shows, and whether it is a video.
void readKind(const ViewSource& given, ViewOptions& options) {
  if (given.depth + given.thermal + given.labels > 1) {
    throw UsageError("options '--depth', '--thermal' and '--labels' can't be combined", "draw one picture of each");
  }
  if (given.depth) options.kind = PictureKind::kDepths;
  if (given.thermal) options.kind = PictureKind::kTemperatures;
  if (given.labels) options.kind = PictureKind::kLabels;
  if (!given.file && (given.thermal || given.labels)) {
    throw UsageError(std::string("option '") + (given.thermal ? "--thermal" : "--labels") + "' can't be used here",
                     "use it with a world file: a running world does not tell temperatures and labels");
  }
  const bool isForVideo = given.length || !options.follow.empty() || options.orbits;
  if (isForVideo && options.video.empty()) {
    throw UsageError("options '--for', '--follow' and '--orbit' are for videos", "add --video FILE.mp4");
  }
  if (!options.video.empty() && (options.terminal || options.sixel || !options.output.empty())) {
    throw UsageError("option '--video' can't be combined with '-o', '--terminal' and '--sixel'");
  }
  if (options.width < 2 || options.height < 2) {
    if (!options.video.empty()) throw UsageError("a video has at least 2 x 2 pixels");
  }
  if (!given.length) return;
  const double seconds = numberFromZero("--for", *given.length, "a number of seconds");
  if (seconds > kLongestVideo) throw UsageError("option '--for' takes at most a day, 86400 seconds");
  options.length = fromSeconds(seconds);
}

/// Sets the source of what to draw.
void readSource(const ViewSource& given, ViewOptions& options) {
  if (given.file && given.file->empty()) throw UsageError("no world file given", "pongsim view WORLD");
  if (given.world && given.world->empty()) throw UsageError("option '-w' needs a world's name");
  const auto refuse = [](const char* option, const char* why) {
    throw UsageError("option '" + std::string(option) + "' can't be used here", why);
  };
  constexpr const char* kOfRunning = "use it without a file, with a running world";
  if (given.file && given.timeout) refuse("--timeout", kOfRunning);
  if (!given.file && given.offline) refuse("--offline", "use it with a world file");
  if (!given.file && given.at) refuse("--at", "use it with a world file: a running world is drawn as it is now");
  options.file = given.file.value_or("");
  options.world = given.world.value_or("");
  if (given.at) options.at = numberFromZero("--at", *given.at, "a number of seconds");
  if (given.timeout) {
    options.timeout = std::chrono::milliseconds(wholeNumber("--timeout", *given.timeout, 0, kLongestMs));
  }
}

}  // namespace

void addViewCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<ViewOptions>();
  const auto source = std::make_shared<ViewSource>();
  CLI::App* command =
      program.add_subcommand("view", "Draw a world after some simulated time, or a running world as it is now");
  const auto add = [command](const char* names, const char* value, const char* description, auto read) {
    command->add_option_function<std::string>(names, read, description)->type_name(value);
  };
  const auto addSource = [add](const char* names, const char* value, const char* description,
                               std::optional<std::string>& target) {
    add(names, value, description, [&target](const std::string& text) { target = text; });
  };
  const auto addFlag = [command](const char* name, bool& target, const char* description) {
    command->add_flag(name, target, description)->disable_flag_override();
  };
  addSource("WORLD", "",
            "World or model file: a path, or a name as for 'pongsim run'. Without it the running world\n"
            "is drawn",
            source->file);
  addSource("--at", "S", "For a file: simulate S seconds first (0)", source->at);
  addSource("-w,--world", "WORLD", "Which world, if several run, or if the file has several (the first one)",
            source->world);
  addSource("--timeout", "MS", "Give up after MS milliseconds (1000) without a running world or its response",
            source->timeout);
  add("--camera", "POSE|MODEL",
      "Camera pose, 'x y z roll pitch yaw', or position 'x y z', looking at the\n"
      "origin; or the model or actor that fills the picture (all of them)",
      [options](const std::string& text) { options->camera = text; });
  add("-o,--output", "FILE", "PNG file to write (view.png, unless --terminal or --sixel)",
      [options](const std::string& text) { options->output = text; });
  add("--size", "WxH", "Pixels, up to 8192 each (1280x720)",
      [options](const std::string& text) { readSize(text, *options); });
  addFlag("--grid", options->grid, "Draw a grid on the ground, with lines 1 m apart");
  addFlag("--axes", options->axes, "Draw the world's axes, 1 m long: x red, y green, z blue");
  addFlag("--names", options->names, "Write the names of models and actors over them");
  addFlag("--depth", source->depth, "Draw distances: the nearest is white, half as bright is twice as far");
  addFlag("--thermal", source->thermal, "For a file: draw temperatures, from black, the coldest, to white");
  addFlag("--labels", source->labels, "For a file: draw labels (system label), each in a colour");
  add("--video", "FILE",
      "Video file to write instead of a picture: .mp4 (H.264), .avi or .ogv. Needs the package\n"
      "pongsim-video",
      [options](const std::string& text) {
        if (text.empty()) throw UsageError("option '--video' needs a file");
        options->video = text;
      });
  addSource("--for", "S", "Length of the video (10), in simulated seconds of a file or real ones of a running world",
            source->length);
  add("--follow", "MODEL", "Move the video's camera with a model or actor",
      [options](const std::string& text) { options->follow = text; });
  addFlag("--orbit", options->orbits, "Move the video's camera once around what it looks at");
  addFlag("--terminal", options->terminal,
          "Draw into the terminal: with sixels if it supports them, otherwise with blocks\n"
          "of 24-bit colour");
  addFlag("--sixel", options->sixel, "Draw into the terminal with sixels, without asking it");
  addNetworkOption(*command);
  addSecureOption(*command);
  CLI::Option* offline = addOfflineOption(*command);
  addRendererOption(*command);
  command->footer(
      "Examples:\n"
      "  pongsim view worlds/pong_world.sdf -o court.png\n"
      "  pongsim view worlds/pong_world.sdf --at 2 --camera pong_bot --size 640x480\n"
      "  pongsim view worlds/pong_world.sdf --camera '-6 -4 3 0 0.4 0.6' --grid --terminal\n"
      "  pongsim view worlds/pong_world.sdf --video court.mp4 --for 5 --orbit\n"
      "  pongsim view --names -o now.png\n"
      "  pongsim view -w pong_world --camera pong_bot --terminal");
  command->callback([options, source, offline, &work] {
    source->offline = offline->count() > 0;
    readSource(*source, *options);
    readKind(*source, *options);
    work = [options] { return viewWorld(*options); };
  });
}

}  // namespace pongsim::cli
