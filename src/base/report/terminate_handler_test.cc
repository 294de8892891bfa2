#include "base/report/terminate_handler.hh"

#include <gtest/gtest.h>

#include <csignal>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace pongsim::base {
namespace {

void failUncaught(const auto& failure) noexcept { failure(); }

TEST(TerminateHandler, SaysThatMemoryHasRunOut) {
  const auto fail = [] {
    installTerminateHandler();
    failUncaught([] { throw std::bad_alloc(); });
  };
  EXPECT_EXIT(fail(), testing::ExitedWithCode(1), "^pongsim: error: can't go on: not enough memory\n$");
}

TEST(TerminateHandler, NamesTheResource) {
  const auto fail = [] {
    installTerminateHandler();
    failUncaught([] { throw std::system_error(EAGAIN, std::generic_category(), "thread"); });
  };
  EXPECT_EXIT(fail(), testing::ExitedWithCode(1), "^pongsim: error: can't go on: thread: Resource temporarily unavail");
}

TEST(TerminateHandler, RemembersMemoryWhereTheExceptionIsGone) {
  const auto fail = [] {
    installTerminateHandler();
    try {
      std::get_new_handler()();
    } catch (const std::bad_alloc&) {
    }
    std::terminate();
  };
  EXPECT_EXIT(fail(), testing::ExitedWithCode(1), "not enough memory");
}

TEST(TerminateHandler, AbortsAfterAMistakeInTheProgram) {
  const auto fail = [] {
    installTerminateHandler();
    failUncaught([] { throw std::logic_error("a mistake"); });
  };
  EXPECT_EXIT(fail(), testing::KilledBySignal(SIGABRT), "a mistake");
}

}  // namespace
}  // namespace pongsim::base
