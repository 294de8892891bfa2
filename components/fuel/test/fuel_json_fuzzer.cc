// Parses arbitrary bytes as a Fuel server's description of models. The parser must return text that is safe to print,
// or throw a Failure.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuel/details.hh"
#include "fuel/failure.hh"
#include "fuzz/require.hh"

namespace {

using pongsim::fuel::Details;

void requirePlain(const Details& details) {
  const auto isPlain = [](const std::string& text) {
    return std::ranges::none_of(text, [](char each) { return (each >= 0 && each < 0x20) || each == 0x7f; });
  };
  for (const std::string* text :
       {&details.owner, &details.name, &details.description, &details.license, &details.created, &details.updated})
    pongsim::fuzz::require(isPlain(*text));
  for (const std::string& tag : details.tags) pongsim::fuzz::require(isPlain(tag));
  pongsim::fuzz::require(details.version >= 0);
}

void requireReason(const auto& work) {
  try {
    work();
  } catch (const pongsim::fuel::Failure& why) {
    pongsim::fuzz::require(why.what()[0] != '\0');
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  requireReason([&] { requirePlain(pongsim::fuel::parseDetails(text)); });
  requireReason([&] {
    for (const Details& each : pongsim::fuel::parseDetailsList(text)) requirePlain(each);
  });
  return 0;
}
