#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/errors.hh"
#include "core/handles.hh"
#include "core/memory.hh"
#include "core/owner.hh"
#include "core/state_vector.hh"
#include "core/values.hh"

namespace pongsim::python {

namespace {

StateVector& vectorOfLife(Life& life, Simulation& simulation) {
  if (!life.stateVector || !life.stateVector->fits(simulation)) {
    life.stateVector = std::make_shared<StateVector>(simulation);
  }
  return *life.stateVector;
}

std::span<double> numbersIn(Memory& memory) {
  return {reinterpret_cast<double*>(memory.bytes.data()), memory.bytes.size() / sizeof(double)};
}

/// @return The numbers of an array of doubles without gaps; `info` keeps it.
std::span<const double> numbersOf(const py::buffer_info& info) {
  if (info.format != py::format_descriptor<double>::format()) throw py::type_error("the numbers must be doubles");
  return {static_cast<const double*>(info.ptr), static_cast<std::size_t>(info.size)};
}

/// @return The numbers of an array, if it is given and has as many.
std::optional<std::span<const double>> given(const std::optional<py::buffer_info>& info, std::size_t count,
                                             const char* what) {
  if (!info) return std::nullopt;
  const std::span<const double> numbers = numbersOf(*info);
  if (numbers.size() == count) return numbers;
  throw py::value_error("the world has " + std::to_string(count) + " " + what + ", not " +
                        std::to_string(numbers.size()));
}

std::shared_ptr<Memory> positions(Owner& owner) {
  const StateVector& vector = vectorOfLife(*owner.life, owner.life->use());
  auto memory = std::make_shared<Memory>(vector.positionCount() * sizeof(double));
  vector.readPositions(numbersIn(*memory));
  return memory;
}

std::shared_ptr<Memory> velocities(Owner& owner) {
  const StateVector& vector = vectorOfLife(*owner.life, owner.life->use());
  auto memory = std::make_shared<Memory>(vector.velocityCount() * sizeof(double));
  vector.readVelocities(numbersIn(*memory));
  return memory;
}

py::list pieces(Owner& owner) {
  py::list list;
  for (const StateVector::Piece& piece : vectorOfLife(*owner.life, owner.life->use()).pieces()) {
    list.append(
        py::make_tuple(piece.name, piece.isFree, piece.position, piece.positions, piece.velocity, piece.velocities));
  }
  return list;
}

void write(Owner& owner, const std::optional<py::buffer>& positions, const std::optional<py::buffer>& velocities) {
  StateVector& vector = vectorOfLife(*owner.life, owner.life->edit("setting the state"));
  std::optional<py::buffer_info> q, v;
  if (positions) q = positions->request();
  if (velocities) v = velocities->request();
  vector.write(given(q, vector.positionCount(), "positions"), given(v, vector.velocityCount(), "velocities"));
}

void moveModels(const std::vector<PyModel*>& models, const py::buffer& poses, bool stop) {
  constexpr std::size_t kSize = 7;
  const py::buffer_info info = poses.request();
  const std::span<const double> numbers = numbersOf(info);
  std::vector<Pose> wanted, before;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const Model& model = models[i]->edit("a move");
    wanted.push_back(poseIn(numbers.subspan(i * kSize, kSize), model.scopedName().c_str()));
  }
  for (std::size_t i = 0; i < models.size(); ++i) {
    Model& model = models[i]->inner;
    before.push_back(model.pose());
    const Outcome<void> done = model.setPose(wanted[i], stop ? AfterMove::kStop : AfterMove::kKeepVelocity);
    if (done) continue;
    for (std::size_t k = i; k-- > 0;) models[k]->inner.setPose(before[k]);
    raise("Refused", "model '" + model.scopedName() + "': " + done.error);
  }
}

void speedUpModels(const std::vector<PyModel*>& models, const py::buffer& velocities) {
  constexpr std::size_t kSize = 6;
  const py::buffer_info info = velocities.request();
  const std::span<const double> all = numbersOf(info);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const double* v = all.subspan(i * kSize, kSize).data();
    const Model& model = models[i]->use();
    if (!model.isStatic()) continue;
    if (std::any_of(v, v + kSize, [](double number) { return number != 0; })) {
      raise("Refused", "model '" + model.scopedName() + "' is static");
    }
  }
  for (std::size_t i = 0; i < models.size(); ++i) {
    const double* v = all.subspan(i * kSize, kSize).data();
    if (models[i]->inner.isStatic()) continue;
    models[i]->use().setVelocity({v[0], v[1], v[2]}, {v[3], v[4], v[5]});
  }
}

std::shared_ptr<Memory> modelVelocities(const std::vector<PyModel*>& models) {
  auto memory = std::make_shared<Memory>(models.size() * 6 * sizeof(double));
  double* to = numbersIn(*memory).data();
  for (PyModel* model : models) {
    const Twist twist = velocityOf(model->use());
    to = std::copy_n(twist.linear.data(), 3, to);
    to = std::copy_n(twist.angular.data(), 3, to);
  }
  return memory;
}

}  // namespace

void bindState(py::class_<Owner>& simulation) {
  simulation.def("_positions", &positions)
      .def("_velocities", &velocities)
      .def("_state_pieces", &pieces)
      .def("_write_state", &write)
      .def_static("_move_models", &moveModels)
      .def_static("_set_model_velocities", &speedUpModels)
      .def_static("_model_velocities", &modelVelocities);
}

}  // namespace pongsim::python
