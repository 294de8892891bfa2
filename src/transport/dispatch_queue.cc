#include "transport/dispatch_queue.hh"

#include <string>
#include <utility>

#include "pongsim/log.hh"

namespace pongsim::transport {

void DispatchQueue::note(std::exception_ptr thrown) {
  if (!failure) {
    failure = std::move(thrown);
    return;
  }
  static const Logger log("transport");
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    log.error(std::string("a function called by dispatch failed: ") + error.what());
  } catch (...) {
    log.error("a function called by dispatch threw something other than a std::exception");
  }
}

}  // namespace pongsim::transport
