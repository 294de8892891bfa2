#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "core/owner.hh"
#include "core/pool.hh"

namespace pongsim::python {

namespace {

std::unique_ptr<Pool> makePool(const std::vector<Owner*>& simulations, std::size_t threads) {
  if (threads < 1) throw py::value_error("threads must be 1 or more");
  std::vector<std::shared_ptr<Life>> lives;
  for (const Owner* simulation : simulations) lives.push_back(simulation->life);
  return std::make_unique<Pool>(std::move(lives), threads);
}

std::shared_ptr<Life> lifeOf(const Owner& simulation) { return simulation.life; }

}  // namespace

void bindPool(py::module_& module) {
  py::class_<LidarLimits>(module, "LidarLimits", "Number of beams and range of a lidar.")
      .def_readonly("beams", &LidarLimits::beams, "Number of beams.")
      .def_readonly("nearest", &LidarLimits::nearest, "Minimum range [m].")
      .def_readonly("farthest", &LidarLimits::farthest, "Maximum range [m].");
  module.def("lidar_limits", &lidarLimits, py::arg("sensor"),
             "The beams of a lidar. Raises ValueError for other sensors.");
  py::class_<Pool>(module, "Pool", "Worlds stepped together on several threads, for pongsim.gym.")
      .def(py::init(&makePool), py::arg("simulations"), py::arg("threads"))
      .def("read_ranges",
           [](Pool& self, std::size_t world, PySensor& sensor) { self.addReading(world, rangesOf(sensor)); })
      .def("read_fields",
           [](Pool& self, std::size_t world, const Owner& simulation, const std::string& topic, const std::string& type,
              const std::vector<std::string>& paths) {
             self.addReading(world, fieldsOf(lifeOf(simulation), topic, type, paths));
           })
      .def("read_pose",
           [](Pool& self, std::size_t world, PyModel& model) { self.addReading(world, poseReading(model)); })
      .def("read_velocity",
           [](Pool& self, std::size_t world, PyModel& model) { self.addReading(world, velocityReading(model)); })
      .def("read_joint",
           [](Pool& self, std::size_t world, PyJoint& joint) { self.addReading(world, jointReading(joint)); })
      .def("steer_fields",
           [](Pool& self, std::size_t world, const Owner& simulation, const std::string& topic, const std::string& type,
              const std::vector<std::string>& paths) {
             self.addSteering(world, messageSteering(lifeOf(simulation), topic, type, paths));
           })
      .def("steer_velocity",
           [](Pool& self, std::size_t world, PyJoint& joint) { self.addSteering(world, velocitySteering(joint)); })
      .def("steer_force",
           [](Pool& self, std::size_t world, PyJoint& joint) { self.addSteering(world, forceSteering(joint)); })
      .def("steer_position",
           [](Pool& self, std::size_t world, PyJoint& joint) {
             auto gains = std::make_shared<Memory>(2 * sizeof(double), true);
             self.addSteering(world, positionSteering(joint, gains));
             return gains;
           })
      .def("limit_action", &Pool::limitAction)
      .def("observe", &Pool::observe)
      .def("seal", &Pool::seal)
      .def("step", &Pool::step)
      .def("save", &Pool::save)
      .def("restore", &Pool::restore)
      .def("missing", &Pool::missing)
      .def_property_readonly("action_size", &Pool::actionSize)
      .def_readonly("actions", &Pool::actions)
      .def_readonly("values", &Pool::values)
      .def_readonly("before", &Pool::before)
      .def_readonly("observations", &Pool::observations)
      .def_readonly("steps", &Pool::steps)
      .def_readonly("commanded", &Pool::commanded)
      .def_readonly("restored", &Pool::restored);
}

}  // namespace pongsim::python
