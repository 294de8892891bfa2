#include "log/mcap/compression.hh"

#include <gtest/gtest.h>

#include "log/store/failure.hh"

namespace pongsim::log {
namespace {

constexpr Compression kAll[] = {Compression::kNone, Compression::kLz4, Compression::kZstd};

std::string failureOf(Compression compression, std::string_view packed, std::uint64_t size) {
  try {
    unpack(compression, packed, size);
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "";
}

std::string someText() {
  std::string text;
  for (int i = 0; i < 200'000; ++i) text += std::to_string(i * 7919 % 1000);
  return text;
}

TEST(Compression, GivesBackWhatItTook) {
  const std::string text = someText();
  for (const Compression each : kAll) {
    Packer packer(each);
    for (const std::string& part : {text, std::string("x"), text.substr(0, 100)}) {
      EXPECT_EQ(unpack(each, packer.pack(part), part.size()), part) << compressionName(each);
    }
    EXPECT_EQ(compressionOf(compressionName(each)), each);
  }
  EXPECT_EQ(compressionOf("brotli"), std::nullopt);
}

TEST(Compression, BelievesNoClaim) {
  const std::string text = someText();
  for (const Compression each : kAll) {
    Packer packer(each);
    const std::string packed(packer.pack(text));
    EXPECT_NE(failureOf(each, packed, text.size() - 1), "") << compressionName(each);
    EXPECT_NE(failureOf(each, packed, text.size() + 1), "") << compressionName(each);
    EXPECT_NE(failureOf(each, packed.substr(0, packed.size() / 2), text.size()), "") << compressionName(each);
    EXPECT_NE(failureOf(each, packed, std::uint64_t{1} << 60U).find("is the limit"), std::string::npos);
  }
}

TEST(Compression, StopsABombAtWhatItClaims) {
  const std::string zeros(std::size_t{100} << 20U, '\0');
  for (const Compression each : {Compression::kLz4, Compression::kZstd}) {
    Packer packer(each);
    const std::string bomb(packer.pack(zeros));
    EXPECT_LT(bomb.size(), zeros.size() / 200);
    EXPECT_NE(failureOf(each, bomb, 1000).find("more than the 1000 bytes"), std::string::npos);
  }
}

TEST(Compression, SumsAsZlibDoes) {
  EXPECT_EQ(crc32Of("123456789"), 0xcbf43926U);
  EXPECT_EQ(crc32Of("6789", crc32Of("12345")), 0xcbf43926U);
}

}  // namespace
}  // namespace pongsim::log
