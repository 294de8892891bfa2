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
#include "cli/options/secure_option.hh"
#include "cli/view/labels.hh"
#include "cli/view/picture_plot.hh"
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

/// Places the camera as the options say.
/// @return The exit code, if that is not possible.
std::optional<int> placeEye(Sight& sight, const std::string& camera, PictureView& view) {
  const std::optional<Pose> pose = readViewpoint(camera);
  if (pose) {
    view.X_WorldEye = *pose;
    return std::nullopt;
  }
  if (!camera.empty()) {
    const std::vector<std::string> names = sight.names();
    if (std::ranges::find(names, camera) == names.end()) {
      std::string hint = base::didYouMean(camera, std::vector<std::string_view>(names.begin(), names.end()));
      if (hint.empty()) hint = "--camera takes the name of a model or an actor, or 'x y z roll pitch yaw'";
      return fail("there is no model or actor '" + camera + "' to look at", hint);
    }
  }
  Eigen::AlignedBox3d box = sight.bounds(camera);
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
  if (const auto code = placeEye(*sight, options.camera, view)) return *code;
  std::vector<std::uint8_t> pixels(std::size_t{3} * options.width * options.height);
  sight->draw(view, pixels);
  if (options.names) drawLabels(labelsOf(*sight, view), options.width, options.height, pixels);
  return show(options, pixels);
}

/// Options given for a file or for a running world.
struct ViewSource {
  std::optional<std::string> file, at, world, timeout;
  bool offline = false;
};

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
  addFlag("--terminal", options->terminal,
          "Draw into the terminal: with sixels if it supports them, otherwise with blocks\n"
          "of 24-bit colour");
  addFlag("--sixel", options->sixel, "Draw into the terminal with sixels, without asking it");
  addNetworkOption(*command);
  addSecureOption(*command);
  CLI::Option* offline = addOfflineOption(*command);
  command->footer(
      "Examples:\n"
      "  pongsim view worlds/pong_world.sdf -o court.png\n"
      "  pongsim view worlds/pong_world.sdf --at 2 --camera pong_bot --size 640x480\n"
      "  pongsim view worlds/pong_world.sdf --camera '-6 -4 3 0 0.4 0.6' --grid --terminal\n"
      "  pongsim view --names -o now.png\n"
      "  pongsim view -w pong_world --camera pong_bot --terminal");
  command->callback([options, source, offline, &work] {
    source->offline = offline->count() > 0;
    readSource(*source, *options);
    work = [options] { return viewWorld(*options); };
  });
}

}  // namespace pongsim::cli
