#include "core/life.hh"

#include <algorithm>
#include <chrono>

#include "core/errors.hh"
#include "core/sensor.hh"

namespace pongsim::python {

namespace {

/// Maximum delay of Ctrl-C.
constexpr std::chrono::milliseconds kLook{50};

std::int64_t now() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

}  // namespace

void Life::checkThread() const {
  if (stepper_ != 0 && stepper_ != PyThread_get_thread_ident()) {
    raise("Busy", "another thread is stepping this simulation; a simulation belongs to one thread at a time");
  }
}

Simulation& Life::use() const {
  if (simulation_ == nullptr) {
    raise("Gone", "the simulation is gone: it was closed, or its Simulation was deleted");
  }
  checkThread();
  return *simulation_;
}

Simulation& Life::edit(const char* what) const {
  Simulation& simulation = use();
  if (stepper_ != 0) {
    raise("Busy", std::string(what) +
                      " is not allowed within a step; do it "
                      "after step() has returned");
  }
  return simulation;
}

void Life::close() {
  if (simulation_ == nullptr) return;
  if (stepper_ != 0) raise("Busy", "a simulation can't be closed while it steps");
  const Outcome<void> done = finish();
  release();
  if (!done) raise("SystemFailed", done.error);
}

Outcome<void> Life::finish() {
  begin();
  Outcome<void> done;
  {
    const interpreter::Released released;
    done = simulation_->finish();
  }
  end();
  return done;
}

void Life::release() {
  if (simulation_ == nullptr) return;
  for (const std::weak_ptr<Pending>& each : std::exchange(pending_, {})) {
    if (const auto pending = each.lock()) pending->letGo();
  }
  for (const std::shared_ptr<Pending>& each : std::exchange(held_, {})) each->letGo();
  streams.clear();
  stateVector.reset();
  rayScene.reset();
  publishers.clear();
  simulation_.reset();
  transport_.reset();
  failure_.reset();
  error_.reset();
}

std::shared_ptr<Kept> Life::keep(py::object object) {
  auto kept = std::make_shared<Kept>(std::move(object));
  if (kept_.size() >= sweepAt_) {
    std::erase_if(kept_, [](const std::weak_ptr<Kept>& each) { return each.expired(); });
    sweepAt_ = std::max<std::size_t>(64, 2 * kept_.size());
  }
  kept_.push_back(kept);
  return kept;
}

void Life::tell(const std::weak_ptr<Pending>& pending) {
  std::erase_if(pending_, [](const std::weak_ptr<Pending>& each) { return each.expired(); });
  pending_.push_back(pending);
}

void Life::forgetPast() {
  failure_.reset();
  for (const std::weak_ptr<Pending>& each : pending_) {
    if (const auto pending = each.lock()) pending->forget();
  }
  for (const std::shared_ptr<Pending>& each : held_) each->forget();
}

int Life::traverse(visitproc visit, void* arg) const {
  for (const std::weak_ptr<Kept>& each : kept_) {
    if (const auto kept = each.lock()) Py_VISIT(kept->ptr());
  }
  if (failure_) Py_VISIT(failure_->ptr());
  if (error_) Py_VISIT(error_->ptr());
  return 0;
}

void Life::begin() {
  stepper_ = PyThread_get_thread_ident();
  if (nextLook_ == 0) nextLook_ = now() + std::chrono::nanoseconds(kLook).count();
}

void Life::end() { stepper_ = 0; }

bool Life::mustStop() {
  if (hasError_ || interpreter::isEnding()) return true;
  if (now() < nextLook_) return false;
  nextLook_ = now() + std::chrono::nanoseconds(kLook).count();
  const interpreter::Held gil;
  if (PyErr_CheckSignals() != 0) {
    py::error_already_set error;
    noteError(error);
  }
  return hasError_;
}

void Life::noteError(py::error_already_set& error) {
  // only the first exception is raised
  if (hasError_) return;
  py::object value = error.value();
  if (error.trace()) PyException_SetTraceback(value.ptr(), error.trace().ptr());
  error_ = std::make_shared<Kept>(std::move(value));
  hasError_ = true;
}

void Life::forgetNoted() {
  hasError_ = false;
  error_.reset();
}

void Life::raiseFailure(const char* what) const {
  const py::object type = errorClass("SystemFailed");
  const py::object exception = type(py::str(what));
  py::object cause = failure();
  if (!cause.is_none()) PyException_SetCause(exception.ptr(), cause.release().ptr());
  PyErr_SetObject(type.ptr(), exception.ptr());
  throw py::error_already_set();
}

void Life::raiseNoted() {
  hasError_ = false;
  const std::shared_ptr<Kept> error = std::exchange(error_, nullptr);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error->ptr())), error->ptr());
  throw py::error_already_set();
}

}  // namespace pongsim::python
