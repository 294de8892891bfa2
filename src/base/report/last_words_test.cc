#include "base/report/last_words.hh"

#include <gtest/gtest.h>

#include <csignal>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace pongsim::base {
namespace {

void failWithoutAWayOut(const auto& failure) noexcept { failure(); }

TEST(LastWords, AreThatMemoryHasRunOut) {
  const auto fail = [] {
    sayLastWords();
    failWithoutAWayOut([] { throw std::bad_alloc(); });
  };
  EXPECT_EXIT(fail(), testing::ExitedWithCode(1), "^pongsim: error: can't go on: not enough memory\n$");
}

TEST(LastWords, AreOfAResource) {
  const auto fail = [] {
    sayLastWords();
    failWithoutAWayOut([] { throw std::system_error(EAGAIN, std::generic_category(), "thread"); });
  };
  EXPECT_EXIT(fail(), testing::ExitedWithCode(1), "^pongsim: error: can't go on: thread: Resource temporarily unavail");
}

TEST(LastWords, AreOfMemoryWhereTheExceptionIsGone) {
  const auto fail = [] {
    sayLastWords();
    try {
      std::get_new_handler()();
    } catch (const std::bad_alloc&) {
    }
    std::terminate();
  };
  EXPECT_EXIT(fail(), testing::ExitedWithCode(1), "not enough memory");
}

TEST(LastWords, AreNoneOfAMistakeInTheProgram) {
  const auto fail = [] {
    sayLastWords();
    failWithoutAWayOut([] { throw std::logic_error("a mistake"); });
  };
  EXPECT_EXIT(fail(), testing::KilledBySignal(SIGABRT), "a mistake");
}

}  // namespace
}  // namespace pongsim::base
