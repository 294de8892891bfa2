#include <CLI/App.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/nearest_word.hh"
#include "cli/command.hh"
#include "cli/console.hh"
#include "cli/diagnostic_report.hh"
#include "cli/number_option.hh"
#include "cli/picture_plot.hh"
#include "cli/terminal_size.hh"
#include "cli/viewpoint.hh"
#include "cli/world_file.hh"
#include "pongsim/camera_scene.hh"
#include "pongsim/log.hh"
#include "pongsim/simulation.hh"

namespace pongsim::cli {

namespace {

constexpr double kFieldOfView = std::numbers::pi / 3;
constexpr std::uint64_t kLongestViewEdge = 8192;

struct ViewCommandOptions {
  std::string world;
  double at = 0;
  std::string camera;
  std::string output;
  std::uint32_t width = 1280;
  std::uint32_t height = 720;
  bool grid = false;
  bool axes = false;
  bool terminal = false;
};

/// Reads "1280x720".
void readSize(const std::string& text, ViewCommandOptions& options) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) throw UsageError("option '--size' takes WIDTHxHEIGHT, not '" + text + "'");
  const auto edge = [](const std::string& number) {
    return static_cast<std::uint32_t>(wholeNumber("--size", number, 1, kLongestViewEdge));
  };
  options.width = edge(text.substr(0, cross));
  options.height = edge(text.substr(cross + 1));
}

PictureView pinhole(const ViewCommandOptions& options) {
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

/// Puts the eye where the options say.
/// @return The exit code, if that can't be.
std::optional<int> placeEye(Simulation& simulation, const CameraScene& scene, const std::string& camera,
                            PictureView& view) {
  const std::optional<Pose> pose = readViewpoint(camera);
  if (pose) {
    view.X_WorldEye = *pose;
    return std::nullopt;
  }
  std::optional<Model> model;
  if (!camera.empty()) {
    model = simulation.world().model(camera);
    if (!model) {
      std::vector<std::string> names;
      for (const Model& each : simulation.world().models()) names.emplace_back(each.scopedName());
      const std::vector<std::string_view> words(names.begin(), names.end());
      std::string hint = base::didYouMean(camera, words);
      if (hint.empty()) hint = "--camera takes the name of a model, or 'x y z roll pitch yaw'";
      return fail("there is no model '" + camera + "' to look at", hint);
    }
  }
  Eigen::AlignedBox3d box = scene.bounds(model);
  if (box.isEmpty()) box = {Vector3(-1, -1, 0), Vector3(1, 1, 1)};
  lookAt(box, view);
  return std::nullopt;
}

int show(const ViewCommandOptions& options, const std::vector<std::uint8_t>& pixels) {
  if (options.terminal) {
    const TerminalSize size = terminalSize();
    // below stands the cursor
    if (!print(picturePlot(pixels, options.width, options.height, size.columns, std::max(1, size.rows - 1)))) {
      return kFailed;
    }
    if (options.output.empty()) return kDone;
  }
  const std::string file = options.output.empty() ? "view.png" : options.output;
  CameraScene::writePicture(file, options.width, options.height, pixels);
  say(file + ": " + std::to_string(options.width) + " x " + std::to_string(options.height) + " pixels");
  return kDone;
}

int viewWorld(const ViewCommandOptions& options) {
  setLogLevel(LogLevel::kWarning);
  Diagnostics diagnostics;
  const std::unique_ptr<Simulation> simulation = Simulation::fromFile(findWorldFile(options.world), {}, diagnostics);
  say(diagnostics, Severity::kWarning, Severity::kError);
  if (simulation == nullptr || diagnostics.hasErrors()) return kFailed;
  simulation->step(static_cast<std::uint64_t>(std::llround(options.at / toSeconds(simulation->stepSize()))));

  CameraScene scene(simulation->world());
  Diagnostics found;
  scene.rebuild(found);
  say(found, Severity::kWarning, Severity::kError);
  scene.update();
  PictureView view = pinhole(options);
  if (const auto code = placeEye(*simulation, scene, options.camera, view)) return *code;
  std::vector<std::uint8_t> pixels(std::size_t{3} * options.width * options.height);
  scene.drawColors(view, pixels);
  return show(options, pixels);
}

}  // namespace

void addViewCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<ViewCommandOptions>();
  CLI::App* command = program.add_subcommand("view", "Draw a world as it stands after some time");
  command->set_help_flag("-h,--help", "Print this and end");
  command
      ->add_option("WORLD", options->world, "World file, or one with a model: a path, or a name as for 'pongsim run'")
      ->type_name("")
      ->required();
  const auto add = [command](const char* names, const char* value, const char* description, auto read) {
    command->add_option_function<std::string>(names, read, description)->type_name(value);
  };
  const auto addFlag = [command](const char* name, bool& target, const char* description) {
    command->add_flag(name, target, description)->disable_flag_override();
  };
  add("--at", "S", "Simulated seconds that go by before (0)",
      [options](const std::string& text) { options->at = numberFromZero("--at", text, "a number of seconds"); });
  add("--camera", "POSE|MODEL",
      "Where the eye is, 'x y z roll pitch yaw' or 'x y z', which looks at\n"
      "the origin; or the model that fills the picture (all of them)",
      [options](const std::string& text) { options->camera = text; });
  add("-o,--output", "FILE", "PNG file to write (view.png, unless --terminal)",
      [options](const std::string& text) { options->output = text; });
  add("--size", "WxH", "Pixels, up to 8192 each (1280x720)",
      [options](const std::string& text) { readSize(text, *options); });
  addFlag("--grid", options->grid, "Draw a grid on the ground, a metre from line to line");
  addFlag("--axes", options->axes, "Draw the world's axes, a metre each: x red, y green, z blue");
  addFlag("--terminal", options->terminal, "Draw it in the terminal, with blocks of 24-bit colour");
  command->footer(
      "Examples:\n"
      "  pongsim view worlds/pong_world.sdf -o court.png\n"
      "  pongsim view worlds/pong_world.sdf --at 2 --camera pong_bot --size 640x480\n"
      "  pongsim view worlds/pong_world.sdf --camera '-6 -4 3 0 0.4 0.6' --grid --terminal");
  command->callback([options, &work] { work = [options] { return viewWorld(*options); }; });
}

}  // namespace pongsim::cli
