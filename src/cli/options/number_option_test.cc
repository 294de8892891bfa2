#include "cli/options/number_option.hh"

#include <gtest/gtest.h>

#include <string>

#include "shared/program/failure.hh"

namespace pongsim::cli {
namespace {

TEST(NumberOption, ReadsWholeNumbersUpTo64Bits) {
  EXPECT_EQ(wholeNumber("--seed", "0"), 0U);
  EXPECT_EQ(wholeNumber("--seed", "18446744073709551615"), ~std::uint64_t{0});
}

TEST(NumberOption, RefusesWhatIsNoWholeNumberWithinTheBounds) {
  for (const char* text : {"", " ", "-1", "+1", "1.0", "1e3", "0x10", "18446744073709551616", "nan", "one", "1 "}) {
    EXPECT_THROW(wholeNumber("--seed", text), UsageError) << text;
  }
  EXPECT_THROW(wholeNumber("-v", "5", 0, 4), UsageError);
  EXPECT_THROW(wholeNumber("-n", "0", 1), UsageError);
}

TEST(NumberOption, NamesTheOptionTheBoundsAndTheText) {
  try {
    wholeNumber("-v", "loud", 0, 4);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "option '-v' takes a whole number from 0 to 4, not 'loud'");
  }
}

TEST(NumberOption, ReadsNumbersFromZero) {
  EXPECT_EQ(numberFromZero("-z", "0", "a rate"), 0);
  EXPECT_EQ(numberFromZero("-z", "2.5e3", "a rate"), 2500);
}

TEST(NumberOption, RefusesNumbersThatAreNegativeOrNotFinite) {
  for (const char* text : {"", "-1", "-0", "nan", "inf", "-inf", "1e999", "1,5", "fast"}) {
    EXPECT_THROW(numberFromZero("-z", text, "a rate"), UsageError) << text;
  }
}

}  // namespace
}  // namespace pongsim::cli
