// Arbitrary bytes as a tlog, an SQLite database. The reader must end, with records or with a reason.

#include <cstddef>
#include <cstdint>

#include "log/tlog/tlog_reader.hh"
#include "read_whole.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return pongsim::fuzz::readWhole<pongsim::log::TlogReader>("a.tlog", data, size);
}
