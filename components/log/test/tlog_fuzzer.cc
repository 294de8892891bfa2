// Arbitrary bytes as a tlog, an SQLite database. The reader must end, with records or with a reason.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/require.hh"
#include "log/store/failure.hh"
#include "log/store/reader.hh"
#include "log/tlog/tlog_reader.hh"
#include "support/temp_folder.hh"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pongsim;
  static const test::TempFolder folder;
  const auto file = folder.write("a.tlog", std::string_view(reinterpret_cast<const char*>(data), size));
  try {
    const log::TlogReader reader(file);
    std::uint64_t bytes = 0;
    for (const log::Topic& topic : reader.topics()) bytes += topic.name.size() + topic.type.size();
    const auto range = reader.timeRange();
    reader.forEach({}, [&](const log::Record& record) {
      bytes += record.payload.size() + record.topic.size() + record.type.size();
      return true;
    });
    // as `pongsim log` shows them
    if (range) reader.forEach({.from = range->last}, [](const log::Record&) { return false; });
    fuzz::require(!reader.torn() || !reader.torn()->empty());
  } catch (const log::Failure& why) {
    fuzz::require(why.what()[0] != '\0');
  }
  return 0;
}
