#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/appearance.hh"
#include "pongsim/math.hh"
#include "pongsim/parameters.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

constexpr const char* kCamera = "photo_shoot::link::camera";
// gives a picture of 48 MB
constexpr std::uint64_t kMostPixels = 16'000'000;

/// A place from which a picture is taken, in sizes of the model from its middle, and where the camera looks.
struct Standpoint {
  Vector3 place;
  /// [degrees]
  double pitch;
  double yaw;
};

/// As in Fortress: from ahead above, from above, from ahead, from the left and from behind.
constexpr int kPictures = 5;
const std::array<Standpoint, kPictures> kStandpoints{{{{1.6, -1.6, 1.2}, 30, -225},
                                                      {{0, 0, 2.2}, 90, 0},
                                                      {{2.2, 0, 0}, 0, -180},
                                                      {{0, 2.2, 0}, 0, -90},
                                                      {{-2.2, 0, 0}, 0, 0}}};

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Takes pictures of its model, once.
class ModelPhotoShoot : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(
        "Takes five pictures of its model with the camera `photo_shoot::link::camera` once there is one: 1.png to "
        "5.png in the current folder.",
        Declaration::Place::kModel);
    declaration.usesFiles();
    declaration.reads("camera");
    declaration.parameter("translation_data_file", &dataFile_, "",
                          "file for the place of the model's middle and the inverse of its size; none if not given");
    declaration.parameter("random_joints_pose", &movesJoints_, "",
                          "moves joints to random positions between their limits before, written into that file too");
  }

  void configure(const SystemContext& context) override {
    world_ = &context.world;
    log_ = &context.log;
    model_ = context.model;
    random_ = &context.random;
    // where the run was started, also if the process goes elsewhere
    folder_ = std::filesystem::current_path();
    if (!dataFile_.empty()) dataFile_ = (folder_ / dataFile_).string();
    worldChanged();
  }

  void worldChanged() override {
    if (isDone_ || camera_) return;
    for (const Sensor& sensor : world_->sensors("camera")) {
      if (sensor.scopedName() == kCamera) camera_ = sensor;
    }
  }

  void preUpdate(const StepInfo& info) override {
    if (movesJoints_ && !info.paused) moveJoints();
    movesJoints_ = movesJoints_ && info.paused;
  }

  void postUpdate(const StepInfo&) override {
    if (isDone_ || !camera_ || !camera_->exists()) return;
    isDone_ = true;
    try {
      takeAll();
      log_->info("pictures of '" + model_->scopedName() + "' are in " + folder_.string());
    } catch (const std::exception& error) {
      failure_ = "no pictures of '" + model_->scopedName() + "': " + error.what();
      throw std::runtime_error(failure_);
    }
  }

  void transfer(StateArchive& archive) override { archive(isDone_); }

  void finish() override {
    if (!failure_.empty()) throw std::runtime_error(failure_);
  }

 private:
  void moveJoints() {
    for (Joint& joint : model_->joints()) {
      if (joint.axisCount() == 0) continue;
      const std::string name(joint.name());
      if (joint.axisCount() > 1 || joint.type() == "screw" || joint.type() == "gearbox") {
        log_->warning("joint '" + name + "' stays: only revolute and prismatic ones are moved");
        continue;
      }
      const JointAxisInfo axis = joint.axisInfo(0);
      const bool turns = joint.type() != "prismatic";
      if (!turns && !(std::isfinite(axis.lower) && std::isfinite(axis.upper))) {
        log_->warning("joint '" + name + "' stays: it is prismatic and has no limits");
        continue;
      }
      const double lower = std::isfinite(axis.lower) ? axis.lower : -std::numbers::pi;
      const double upper = std::isfinite(axis.upper) ? axis.upper : std::numbers::pi;
      const double position = lower + random_->uniform() * (upper - lower);
      if (const Outcome<void> moved = joint.resetPosition(position); !moved) {
        log_->warning("joint '" + name + "' stays: " + moved.error);
        continue;
      }
      positions_.emplace_back(name, position);
    }
  }

  void takeAll() {
    Diagnostics diagnostics;
    CameraScene scene(*world_);
    // as in Fortress
    scene.setColors(std::nullopt, Vector3::Constant(0.3));
    scene.addLight({.name = "photo shoot, directional",
                    .type = VisibleLight::Type::kDirectional,
                    .X_WorldLight = {},
                    .direction = Vector3(-0.5, 0.5, -1).normalized(),
                    .diffuse = Vector3::Constant(0.8)});
    scene.addLight({.name = "photo shoot, point",
                    .type = VisibleLight::Type::kPoint,
                    .X_WorldLight = {{3, 5, 5}, Quaternion::Identity()},
                    .direction = -Vector3::UnitZ(),
                    .diffuse = Vector3::Constant(0.5)});
    scene.rebuild(diagnostics);
    scene.update();
    for (const Diagnostic& each : diagnostics.all()) log_->warning(format(each));
    const Eigen::AlignedBox3d box = scene.bounds(model_);
    if (box.isEmpty() || !(box.sizes().maxCoeff() > 0)) throw std::runtime_error("nothing of it is visible");
    write(box);
    for (std::size_t i = 0; i < kStandpoints.size(); ++i) take(scene, kStandpoints[i], box, std::to_string(i + 1));
  }

  void take(CameraScene& scene, const Standpoint& standpoint, const Eigen::AlignedBox3d& box, const std::string& name) {
    const auto* camera = camera_->settings<CameraSettings>();
    if (std::uint64_t{camera->width} * camera->height > kMostPixels) {
      throw std::runtime_error("the camera has more than " + std::to_string(kMostPixels) + " pixels");
    }
    PictureView view;
    view.width = camera->width;
    view.height = camera->height;
    view.fx = view.fy = camera->width / (2 * math::tan(camera->horizontalFov / 2));
    view.cx = camera->width / 2.0;
    view.cy = camera->height / 2.0;
    view.near = camera->clip.near;
    view.far = camera->clip.far;
    view.visibilityMask = camera->visibilityMask;
    view.antiAliasing = camera->antiAliasing;
    view.X_WorldEye = {box.center() + standpoint.place * box.sizes().maxCoeff(),
                       fromRollPitchYaw(0, radians(standpoint.pitch), radians(standpoint.yaw))};
    std::vector<std::uint8_t> pixels(std::size_t{3} * view.width * view.height);
    scene.drawColors(view, pixels);
    CameraScene::writePicture(folder_ / (name + ".png"), view.width, view.height, pixels);
  }

  void write(const Eigen::AlignedBox3d& box) const {
    if (dataFile_.empty()) return;
    std::ofstream stream(dataFile_, std::ios::trunc);
    for (const auto& [joint, position] : positions_)
      stream << joint << ": " << std::setprecision(17) << position << '\n';
    const Vector3 middle = box.center();
    stream << "Translation: " << middle.x() << ' ' << middle.y() << ' ' << middle.z() << '\n'
           << "Scaling: " << 1 / box.sizes().maxCoeff() << '\n';
    stream.close();
    if (!stream) throw std::runtime_error("'" + dataFile_ + "' can't be written");
  }

  std::string dataFile_;
  bool movesJoints_ = false;
  World* world_ = nullptr;
  const Logger* log_ = nullptr;
  Random* random_ = nullptr;
  std::optional<Model> model_;
  std::optional<Sensor> camera_;
  std::filesystem::path folder_;
  std::vector<std::pair<std::string, double>> positions_;
  bool isDone_ = false;
  std::string failure_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ModelPhotoShoot, "ignition::gazebo::systems::ModelPhotoShoot",
                      "gz::sim::systems::ModelPhotoShoot");
