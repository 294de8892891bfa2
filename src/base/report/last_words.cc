#include "base/report/last_words.hh"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

namespace pongsim::base {

namespace {

// In some cases no exception is left that would tell.
std::atomic<bool> hasMemoryFailed = false;

// The library's handler, which prints the exception and aborts with SIGABRT.
std::terminate_handler endAsBefore = std::abort;

void write(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

/// Allocates no memory.
[[noreturn]] void endFor(const char* what) {
  write("pongsim: error: can't go on: ");
  write(what);
  write("\n");
  std::_Exit(EXIT_FAILURE);
}

void terminate() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    endFor("not enough memory");
  } catch (const std::system_error& error) {
    if (!hasMemoryFailed) endFor(error.what());
  } catch (...) {
    endAsBefore();
  }
  if (hasMemoryFailed) endFor("not enough memory");
  endAsBefore();
}

}  // namespace

void sayLastWords() {
  std::set_new_handler([] {
    hasMemoryFailed = true;
    throw std::bad_alloc();
  });
  if (const std::terminate_handler before = std::set_terminate(terminate); before != nullptr && before != terminate) {
    endAsBefore = before;
  }
}

}  // namespace pongsim::base
