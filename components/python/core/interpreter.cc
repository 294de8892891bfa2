#include "core/interpreter.hh"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace pongsim::python::interpreter {

namespace {

/// How long the end of the program waits for a Python function that a step has called and that does not return.
constexpr std::chrono::seconds kPatience{5};

/// Steps have to stop.
std::atomic<bool> ending = false;
/// Other threads no longer get the lock.
std::atomic<bool> ended = false;
/// The thread that ends the program.
std::atomic<std::thread::id> ender;
/// Objects of this file's classes on the stacks of all threads, and threads that are about to get the lock.
std::atomic<int> inside = 0;
std::atomic<int> entering = 0;
thread_local int depth = 0;
/// A fork has none of the other threads.
pid_t process = 0;

bool isEnder() { return ender.load() == std::this_thread::get_id(); }

/// Stops this thread until the process is gone.
[[noreturn]] void hang() {
  inside -= depth;
  if (PyGILState_Check() != 0) PyEval_SaveThread();
  for (;;) pause();
}

/// Called before the lock is taken; `entering` is decremented afterwards.
void enter() {
  ++entering;
  if (!ended || isEnder()) return;
  --entering;
  hang();
}

void waitForNone(const std::atomic<int>& count) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (count > 0 && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void end() {
  ender = std::this_thread::get_id();
  ending = true;
  if (getpid() != process) return;
  PyThreadState* state = PyEval_SaveThread();
  waitForNone(inside);
  ended = true;
  waitForNone(entering);
  PyEval_RestoreThread(state);
}

}  // namespace

void expectEnd() {
  process = getpid();
  pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function(&end));
}

bool isEnding() { return ending && !isEnder(); }

Released::Released() {
  if (isEnding()) hang();
  ++inside;
  ++depth;
  state_ = PyEval_SaveThread();
}

Released::~Released() {
  // its step has stopped early: nobody must take it for complete
  if (isEnding()) hang();
  enter();
  PyEval_RestoreThread(state_);
  --entering;
  --depth;
  --inside;
}

Held::Held() {
  enter();
  acquired_.emplace();
  --entering;
  ++depth;
  ++inside;
}

Held::~Held() {
  acquired_.reset();
  --depth;
  --inside;
}

}  // namespace pongsim::python::interpreter
