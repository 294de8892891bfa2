#include "cli/extension/extension_value.hh"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

ExtensionValue valueOf(const char* descriptor) { return ExtensionValue(nlohmann::json::parse(descriptor)); }

/// @return What is said of the text; empty where it is taken.
std::string said(const ExtensionValue& value, const std::string& text) {
  try {
    value.check("--x", text);
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(ExtensionValue, IsAnyTextUnlessTheDescriptorSaysMore) {
  for (const char* text : {"", "x", "-1"}) {
    EXPECT_EQ(said({}, text), "");
    EXPECT_EQ(said(valueOf("{}"), text), "");
  }
  EXPECT_FALSE(valueOf("{}").isLimited());
}

TEST(ExtensionValue, IsAFiniteNumberWithinItsBounds) {
  const ExtensionValue period = valueOf(R"({"type": "number", "least": 0})");
  EXPECT_TRUE(period.isLimited());
  for (const char* text : {"0", "0.5", "1e3"}) EXPECT_EQ(said(period, text), "");
  for (const char* text : {"", "x", "1s", "-0.1", "nan", "inf"}) {
    EXPECT_EQ(said(period, text), "option '--x' takes a number from 0, not '" + std::string(text) + "'");
  }
  EXPECT_EQ(said(valueOf(R"({"type": "number", "most": 1.5})"), "2"), "option '--x' takes a number up to 1.5, not '2'");
  EXPECT_EQ(said(valueOf(R"({"type": "number"})"), "-7"), "");
}

TEST(ExtensionValue, IsAWholeNumber) {
  const ExtensionValue domain = valueOf(R"({"type": "whole number", "least": 0, "most": 232})");
  for (const char* text : {"0", "232"}) EXPECT_EQ(said(domain, text), "");
  for (const char* text : {"1.5", "233", "-1", "1e2"}) {
    EXPECT_EQ(said(domain, text), "option '--x' takes a whole number from 0 to 232, not '" + std::string(text) + "'");
  }
}

TEST(ExtensionValue, IsOneOfTheWords) {
  const ExtensionValue packing = valueOf(R"({"words": ["zstd", "lz4"]})");
  EXPECT_EQ(said(packing, "lz4"), "");
  EXPECT_EQ(said(packing, "gzip"), "option '--x' takes one of 'zstd', 'lz4', not 'gzip'");
}

TEST(ExtensionValue, ThatMakesNoSenseIsRefused) {
  for (const char* text : {R"({"type": "length"})", R"({"least": 0})", R"({"type": "number", "words": ["a"]})"}) {
    EXPECT_THROW(valueOf(text), std::runtime_error) << text;
  }
  EXPECT_THROW(valueOf(R"({"type": "number", "least": "a"})"), nlohmann::json::exception);
}

}  // namespace
}  // namespace pongsim::cli
