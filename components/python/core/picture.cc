#include "core/picture.hh"

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/errors.hh"
#include "core/life.hh"
#include "core/memory.hh"
#include "core/owner.hh"
#include "core/sensor.hh"
#include "core/values.hh"
#include "pongsim/sensing/camera_scene.hh"
#include "pongsim/sensing/sensor_settings.hh"

namespace pongsim::python {

namespace {

constexpr std::uint32_t kLargestEdge = 8192;
/// The near clipping distance [m].
constexpr double kNearest = 0.01;

/// Renders the current state of a world, without changing it.
class Painter final : public Life::Pending {
 public:
  explicit Painter(std::shared_ptr<Life> life)
      : life_(std::move(life)), scene_(std::make_unique<CameraScene>(life_->use().world())) {}

  void letGo() override { scene_.reset(); }

  /// @return Red, green, blue of each pixel, row by row from the top.
  std::shared_ptr<Memory> draw(py::handle frame, py::handle eye, std::uint32_t width, std::uint32_t height,
                               double fieldOfView) {
    Simulation& simulation = life_->edit("drawing");
    PictureView view = viewOf(width, height, fieldOfView);
    view.X_WorldEye = poseFrom(frame) * poseFrom(eye);
    auto pixels = std::make_shared<Memory>(std::size_t{3} * width * height, true);
    Diagnostics diagnostics;
    life_->stepping([&] {
      lookAround(simulation, diagnostics);
      scene_->drawColors(view, {reinterpret_cast<std::uint8_t*>(pixels->bytes.data()), pixels->bytes.size()});
    });
    warnOf(diagnostics.all());
    return pixels;
  }

  /// @return The bounding box of all visuals: minimum x, y, z, maximum x, y, z; a metre around the origin if there are
  /// none.
  py::tuple bounds() {
    Diagnostics diagnostics;
    lookAround(life_->edit("drawing"), diagnostics);
    warnOf(diagnostics.all());
    Eigen::AlignedBox3d box = scene_->bounds();
    if (box.isEmpty()) box = {Vector3(-1, -1, -1), Vector3(1, 1, 1)};
    return py::make_tuple(tupleOf(box.min()), tupleOf(box.max()));
  }

 private:
  static PictureView viewOf(std::uint32_t width, std::uint32_t height, double fieldOfView) {
    if (width < 1 || height < 1 || width > kLargestEdge || height > kLargestEdge) {
      throw py::value_error("a picture must be 1 to " + std::to_string(kLargestEdge) + " pixels wide and high");
    }
    if (!(fieldOfView > 0 && fieldOfView < 3.1))
      throw py::value_error("a field of view must be above 0 and below 3.1 rad");
    PictureView view;
    view.width = width;
    view.height = height;
    view.fx = view.fy = width / (2 * std::tan(fieldOfView / 2));
    view.cx = width / 2.0;
    view.cy = height / 2.0;
    view.near = kNearest;
    view.far = INFINITY;
    return view;
  }

  /// Updates the visuals if models were inserted or removed, and their poses.
  void lookAround(Simulation& simulation, Diagnostics& diagnostics) {
    std::vector<ModelId> models;
    for (const Model& model : simulation.world().models()) models.push_back(model.id());
    if (!models_ || *models_ != models) scene_->rebuild(diagnostics);
    models_ = std::move(models);
    scene_->update();
  }

  std::shared_ptr<Life> life_;
  std::unique_ptr<CameraScene> scene_;
  std::optional<std::vector<ModelId>> models_;
};

std::shared_ptr<Painter> make(const Owner& simulation) {
  auto painter = std::make_shared<Painter>(simulation.life);
  simulation.life->tell(painter);
  return painter;
}

/// @return Width, height, horizontal field of view, and pose of the eye in the sensor's frame.
py::tuple lensOf(PySensor& sensor) {
  const auto* settings = sensor.use().settings<CameraSettings>();
  if (settings == nullptr) {
    throw py::value_error("sensor '" + sensor.use().scopedName() + "' is not a camera but of type " +
                          std::string(sensor.use().type()));
  }
  return py::make_tuple(settings->width, settings->height, settings->horizontalFov, poseOf(settings->X_SensorCamera));
}

}  // namespace

void bindPictures(py::module_& module) {
  py::class_<Painter, std::shared_ptr<Painter>>(
      module, "Painter", "Renders a world from any pose, without a camera in it. Changes nothing.")
      .def(py::init(&make), py::arg("simulation"))
      .def("draw", &Painter::draw, py::arg("frame"), py::arg("eye"), py::arg("width"), py::arg("height"),
           py::arg("field_of_view"),
           "Red, green, blue of each pixel (8 bits each), row by row from the top.\n\n"
           "frame: pose of a frame in the world frame.\n"
           "eye: pose of the camera in that frame; it looks along its x axis with z up.\n"
           "width, height: [pixels]; field_of_view: horizontal [rad].")
      .def("bounds", &Painter::bounds, "Bounding box of everything visible: its minimum and maximum, world frame [m].");
  module.def("lens", &lensOf, py::arg("sensor"),
             "Of a camera: width and height [pixels], horizontal field of view [rad], and its pose in the "
             "sensor's frame. Raises ValueError for others.");
}

}  // namespace pongsim::python
