#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "cli/files/diagnostic_report.hh"
#include "cli/files/world_file.hh"
#include "cli/view/view_command.hh"
#include "pongsim/actor.hh"
#include "pongsim/simulation.hh"

namespace pongsim::cli {

namespace {

class FileSight final : public Sight {
 public:
  explicit FileSight(std::unique_ptr<Simulation> simulation)
      : simulation_(std::move(simulation)), scene_(simulation_->world()), start_(simulation_->time()) {
    scene_.setMarkerViewers(MarkerViewers::kPeople);
    Diagnostics found;
    scene_.rebuild(found);
    say(found, Severity::kWarning, Severity::kError);
    scene_.update();
  }

  std::vector<std::string> names() override {
    std::vector<std::string> names;
    for (const Model& each : simulation_->world().models()) names.emplace_back(each.scopedName());
    for (std::string& actor : scene_.actors()) names.push_back(std::move(actor));
    return names;
  }

  Eigen::AlignedBox3d bounds(const std::string& name) override {
    if (name.empty()) return scene_.bounds();
    const std::optional<Model> model = simulation_->world().model(name);
    return model ? scene_.bounds(model) : scene_.actorBounds(name);
  }

  std::optional<Vector3> position(const std::string& name) override {
    if (const std::optional<Model> model = simulation_->world().model(name)) return model->pose().position;
    const std::optional<Actor> actor = Actor::find(simulation_->world(), name);
    return actor ? std::optional(actor->pose().position) : std::nullopt;
  }

  std::optional<Time> advance(Time time) override {
    const Time left = start_ + time - simulation_->time(), step = simulation_->stepSize();
    if (left > Time(0)) simulation_->step(static_cast<std::uint64_t>((left + step - Time(1)) / step));
    scene_.update();
    return std::max(time, simulation_->time() - start_);
  }

  void drawColors(const PictureView& view, std::span<std::uint8_t> pixels) override { scene_.drawColors(view, pixels); }
  void drawDepths(const PictureView& view, std::span<float> depths) override { scene_.drawDepths(view, depths); }
  void drawTemperatures(const PictureView& view, std::span<float> temperatures) override {
    scene_.drawTemperatures(view, temperatures);
  }
  void drawNumbers(const PictureView& view, std::span<std::uint32_t> numbers) override {
    scene_.drawNumbers(view, numbers);
  }
  std::span<const SeenVisual> visuals() override { return scene_.visuals(); }

 private:
  std::unique_ptr<Simulation> simulation_;
  CameraScene scene_;
  Time start_;
};

}  // namespace

std::unique_ptr<Sight> sightOfFile(const ViewOptions& options) {
  Diagnostics diagnostics;
  const std::optional<std::filesystem::path> file = fetchWorldFile(options.file, diagnostics);
  std::unique_ptr<Simulation> simulation =
      file ? Simulation::fromFile(*file, {.world = options.world}, diagnostics) : nullptr;
  say(diagnostics, Severity::kWarning, Severity::kError);
  if (simulation == nullptr || diagnostics.hasErrors()) return nullptr;
  simulation->step(static_cast<std::uint64_t>(std::llround(options.at / toSeconds(simulation->stepSize()))));
  return std::make_unique<FileSight>(std::move(simulation));
}

}  // namespace pongsim::cli
