#pragma once

#include <pybind11/pybind11.h>

#include <optional>

namespace pongsim::python {

/// Python's interpreter lock, and the end of the program. Up to 3.13, Python ends a daemon thread that wants the lock
/// while the program ends by unwinding its stack, which C++ code under it does not survive: the program aborts. So when
/// the program ends, running steps stop early, and threads that then want the lock wait for ever instead.
namespace interpreter {

/// Prepares for the end of the program. Call once, when the module is loaded.
void expectEnd();

/// @return Whether the program ends and the calling thread is not the one that ends it: then a step has to stop.
bool isEnding();

/// Releases the lock while it exists.
class Released {
 public:
  Released();
  ~Released();
  Released(const Released&) = delete;
  Released& operator=(const Released&) = delete;

 private:
  PyThreadState* state_;
};

/// Holds the lock while it exists, to call Python from any thread.
class Held {
 public:
  Held();
  ~Held();
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

 private:
  std::optional<pybind11::gil_scoped_acquire> acquired_;
};

}  // namespace interpreter

}  // namespace pongsim::python
