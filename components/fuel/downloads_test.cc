#include "fuel/downloads.hh"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>

#include "support/temp_folder.hh"
#include "support/thread_limit.hh"

namespace pongsim::fuel {
namespace {

// Downloads themselves are tested by test/test_download.py and test/test_faults.py.

std::string keyOf(const std::string& address) { return fuel::keyOf(*parseFuelAddress(address)); }

TEST(Downloads, KnowAModelByAllItsAddresses) {
  const std::string key = keyOf("https://fuel.gazebosim.org/1.0/Owner/models/A Model");
  EXPECT_EQ(keyOf("http://fuel.ignitionrobotics.org/owner/models/a%20model/tip/files/x"), key);
  EXPECT_NE(keyOf("https://fuel.gazebosim.org/1.0/owner/models/a model/1"), key);
  EXPECT_NE(keyOf("https://fuel.gazebosim.org/1.0/owner/worlds/a model"), key);
  EXPECT_NE(keyOf("https://example.org/1.0/owner/models/a model"), key);
}

TEST(DownloadsDeathTest, GoOnWithTheThreadsThatCouldBeStarted) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need more address space";
#endif
  const auto runWithoutMemory = [] {
    std::ifstream statistics("/proc/self/statm");
    rlim_t pages = 0;
    statistics >> pages;
    // room for one more thread with a stack of 8 MiB, but not for fifteen
    const rlim_t bytes = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t{24} << 20);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_AS, &limit);
    Progress progress(0, false);
    DownloadOptions options;
    options.jobs = 16;
    const bool isDone = Downloads({}, options, progress).run({}).empty();
    _exit(isDone ? 0 : 1);
  };
  EXPECT_EXIT(runWithoutMemory(), testing::ExitedWithCode(0), "");
}

TEST(Downloads, SeeWhatAModelNeeds) {
  const test::TempFolder folder;
  folder.write("model.sdf",
               "<sdf><model><include><uri>https://h/1.0/o/models/a/2</uri></include><link><visual><geometry><mesh>"
               "<uri>https://h/1.0/o/models/a/2/files/m.dae</uri></mesh></geometry></visual></link></model></sdf>");
  folder.write("model.config", "<model><depend><model><uri>https://h/o/models/b</uri></model></depend></model>");
  folder.write("metadata.pbtxt", "dependencies { uri: \"https://h/1.0/o/models/c\" }");
  folder.write("meshes/other.sdf", "<uri>https://h/1.0/o/models/d</uri>");
  std::string names;
  for (const FuelAddress& each : neededBy(folder.path())) names += nameOf(each) + ";";
  EXPECT_EQ(names, "o/a version 2;o/b;o/c;");
}

TEST(Downloads, AreFewerAtOnceWhereTheSystemHasNoMoreThreads) {
  const Settings settings;
  const DownloadOptions options{.jobs = 8};
  Progress progress(2, false);
  testing::internal::CaptureStderr();
  {
    const test::ThreadLimit limit(2);
    EXPECT_TRUE(Downloads(settings, options, progress).run({}).empty());
  }
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find("at most 3 downloads at once: Resource temporarily unavailable"), std::string::npos) << said;
}

}  // namespace
}  // namespace pongsim::fuel
