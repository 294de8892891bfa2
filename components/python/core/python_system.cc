#include "core/python_system.hh"

#include <stdexcept>
#include <utility>

#include "core/errors.hh"

namespace pongsim::python {

PythonSystem::PythonSystem(Life& life, py::object system) : life_(life), self_(life.keep(std::move(system))) {
  preUpdate_ = own("pre_update");
  update_ = own("update");
  postUpdate_ = own("post_update");
  reset_ = own("reset");
  worldChanged_ = own("world_changed");
  save_ = own("save");
  restore_ = own("restore");
}

PythonSystem::~PythonSystem() = default;

PythonSystem::Method PythonSystem::own(const char* name) const {
  const py::object type = py::type::of(self_->get());
  const py::object base = py::module_::import("pongsim.system").attr("System");
  if (type.attr(name).is(base.attr(name))) return nullptr;
  return life_.keep(self_->get().attr(name));
}

void PythonSystem::declare(Declaration& declaration) {
  declaration.is("A system in Python.", Declaration::Place::kWorld);
}

void PythonSystem::configure(const SystemContext&) {
  guarded([this] { self_->get().attr("configure")(); });
}

void PythonSystem::reset() {
  guarded([this] { self_->get().attr("error") = py::none(); });
  call(reset_, nullptr);
}

/// Throws what a C++ system would throw; the original Python exception becomes the system's `error`, and the cause of
/// what the step raises.
template <class Work>
void PythonSystem::guarded(Work work) {
  const interpreter::Held gil;
  try {
    work();
  } catch (py::error_already_set& error) {
    // Ctrl-C and sys.exit are not failures of the system
    if (!error.matches(PyExc_Exception)) return life_.noteError(error);
    py::object exception = error.value();
    if (error.trace()) PyException_SetTraceback(exception.ptr(), error.trace().ptr());
    const std::string what = describe(error);
    const bool isGone = error.matches(errorClass("Gone"));
    self_->get().attr("error") = exception;
    life_.noteFailure(std::move(exception));
    if (isGone) throw Gone(what);
    throw std::runtime_error(what);
  }
}

void PythonSystem::call(const Method& method, const StepInfo* info) {
  if (!method) return;
  guarded([&] { info == nullptr ? method->get()() : method->get()(*info); });
}

void PythonSystem::transfer(StateArchive& archive) {
  const interpreter::Held gil;
  try {
    const py::module_ values = py::module_::import("pongsim.saved_value");
    std::string bytes;
    bool isWell = self_->get().attr("error").is_none();
    archive(isWell);
    if (archive.isGiving() && isWell) self_->get().attr("error") = py::none();
    if (!save_ || !restore_) return;
    if (!archive.isGiving()) {
      bytes = values.attr("encode")(save_->get()(), py::type::of(self_->get()).attr("__name__")).cast<std::string>();
    }
    archive(bytes);
    if (archive.isGiving()) restore_->get()(values.attr("decode")(py::bytes(bytes)));
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_Exception)) return life_.noteError(error);
    // whoever saves gets the exception itself; whoever restores, a refusal
    if (!archive.isGiving()) throw;
    throw std::runtime_error(describe(error));
  }
}

void bindSystems(py::module_& module) {
  py::class_<StepInfo>(module, "StepInfo", "Time and iteration of a call to a system.")
      .def_property_readonly(
          "time", [](const StepInfo& info) { return toSeconds(info.time); },
          "Simulated time at the end of this step [s].")
      .def_property_readonly(
          "time_ns", [](const StepInfo& info) { return info.time.count(); }, "The same in whole nanoseconds.")
      .def_property_readonly(
          "dt", [](const StepInfo& info) { return toSeconds(info.dt); }, "Length of the step [s].")
      .def_property_readonly(
          "iteration", [](const StepInfo& info) { return info.iteration; }, "Steps made, including this one.");
}

}  // namespace pongsim::python
