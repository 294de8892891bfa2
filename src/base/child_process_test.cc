#include "base/child_process.hh"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string_view>

#include "base/file_descriptor.hh"

namespace pongsim::base {
namespace {

TEST(ChildProcess, GivesOutputAndStatus) {
  const auto done = runChild("/bin/sh", {"-c", "echo \"$0\"; exit 3", "a word"});
  ASSERT_TRUE(done);
  EXPECT_EQ(done.value->output, "a word\n");
  EXPECT_TRUE(WIFEXITED(done.value->status));
  EXPECT_EQ(WEXITSTATUS(done.value->status), 3);
}

TEST(ChildProcess, ReadsItsInput) {
  const FileDescriptor input(::memfd_create("input", MFD_CLOEXEC));
  constexpr std::string_view kText = "some text";
  ASSERT_EQ(::write(input.number(), kText.data(), kText.size()), static_cast<ssize_t>(kText.size()));
  ASSERT_EQ(::lseek(input.number(), 0, SEEK_SET), 0);
  EXPECT_EQ(runChild("/bin/cat", {}, input.number()).value.value().output, kText);
}

TEST(ChildProcess, CanBeEndedBySignalsThatThisProcessBlocks) {
  sigset_t blocked, before;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &blocked, &before);
  const auto done = runChild("/bin/sh", {"-c", "kill -TERM $$; echo survived"});
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ASSERT_TRUE(done);
  EXPECT_EQ(done.value->output, "");
  EXPECT_TRUE(WIFSIGNALED(done.value->status));
}

TEST(ChildProcess, SaysWhyItCantBeRun) {
  EXPECT_EQ(runChild("/no/such/program", {}).error, "/no/such/program can't be run: No such file or directory");
}

}  // namespace
}  // namespace pongsim::base
