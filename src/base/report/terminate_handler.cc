#include "base/report/terminate_handler.hh"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

namespace pongsim::base {

namespace {

// Set when an allocation fails, because std::terminate may be called without a current exception.
std::atomic<bool> hasMemoryFailed = false;

// The handler before ours: the standard library's prints the exception and aborts with SIGABRT.
std::terminate_handler previousHandler = std::abort;

void write(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

/// Prints the error and exits, without allocating memory.
[[noreturn]] void exitWithError(const char* what) {
  write("pongsim: error: can't go on: ");
  write(what);
  write("\n");
  std::_Exit(EXIT_FAILURE);
}

void terminate() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    exitWithError("not enough memory");
  } catch (const std::system_error& error) {
    if (!hasMemoryFailed) exitWithError(error.what());
  } catch (...) {
    previousHandler();
  }
  if (hasMemoryFailed) exitWithError("not enough memory");
  previousHandler();
}

}  // namespace

void installTerminateHandler() {
  std::set_new_handler([] {
    hasMemoryFailed = true;
    throw std::bad_alloc();
  });
  if (const std::terminate_handler before = std::set_terminate(terminate); before != nullptr && before != terminate) {
    previousHandler = before;
  }
}

}  // namespace pongsim::base
