#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "fuzz/require.hh"
#include "log/store/failure.hh"
#include "log/store/reader.hh"
#include "support/temp_folder.hh"

namespace pongsim::fuzz {

/// Reads a recording of these bytes to its end, as `pongsim log` does. The reader must end, with records or with a
/// reason.
/// @param name Of the file.
template <class Reader>
int readWhole(const char* name, const std::uint8_t* data, std::size_t size) {
  static const test::TempFolder folder;
  const auto file = folder.write(name, std::string_view(reinterpret_cast<const char*>(data), size));
  try {
    const Reader reader(file);
    [[maybe_unused]] std::uint64_t bytes = 0;  // adding them reads what was found
    for (const log::Topic& topic : reader.topics()) bytes += topic.name.size() + topic.type.size();
    const auto range = reader.timeRange();
    reader.forEach({}, [&](const log::Record& record) {
      bytes += record.payload.size() + record.topic.size() + record.type.size();
      return true;
    });
    if (range) reader.forEach({.from = range->last}, [](const log::Record&) { return false; });
    require(!reader.torn() || !reader.torn()->empty());
  } catch (const log::Failure& why) {
    require(why.what()[0] != '\0');
  }
  return 0;
}

}  // namespace pongsim::fuzz
