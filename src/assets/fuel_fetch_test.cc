#include "assets/fuel_fetch.hh"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "pongsim/log.hh"
#include "support/temp_folder.hh"

namespace pongsim::assets {
namespace {

namespace fs = std::filesystem;

/// With a script instead of the download program.
class FuelFetchTest : public testing::Test {
 protected:
  FuelFetchTest() { unsetenv("PONGSIM_OFFLINE"); }
  ~FuelFetchTest() override { setenv("PONGSIM_OFFLINE", "1", 1); }

  FuelFetch fetchBy(const std::string& script) {
    const fs::path program = folder_.write("program", "#!/bin/sh\n" + script);
    fs::permissions(program, fs::perms::owner_all);
    return FuelFetch({{}, folder_.path() / "cache"}, program);
  }
  std::string asked() const {
    std::ifstream stream(folder_.path() / "asked");
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  test::TempFolder folder_;
  const std::string model_ = "https://fuel.gazebosim.org/1.0/o/models/m";
};

TEST_F(FuelFetchTest, AsksOnceForAllThatIsMissing) {
  folder_.write("cache/fuel.gazebosim.org/o/models/here/2/model.config", "");
  FuelFetch fetch = fetchBy("cat >>" + (folder_.path() / "asked").string());
  fetch.bring({model_, "https://fuel.gazebosim.org/o/models/here", model_ + "/tip/files/a.dae", model_ + "/3",
               "https://example.org/x", "model://m", model_ + "/3/files/x y.png"});
  EXPECT_EQ(asked(), model_ + "/tip\n" + model_ + "/3\n");
  fetch.bring({model_});
  EXPECT_EQ(asked(), model_ + "/tip\n" + model_ + "/3\n");
}

TEST_F(FuelFetchTest, PassesOnHowMuchIsToBeSaid) {
  const std::string script = "echo $* >>" + (folder_.path() / "asked").string();
  fetchBy(script).bring({model_});
  setLogLevel(LogLevel::kError);
  fetchBy(script).bring({model_});
  setLogLevel(LogLevel::kWarning);
  EXPECT_EQ(asked(), "fetch -v 3\nfetch -v 1\n");
}

TEST_F(FuelFetchTest, TellsWhatTheProgramSays) {
  FuelFetch fetch = fetchBy("printf 'failed " + model_ + "/tip\\tthe server has none\\tlook again\\n'");
  fetch.bring({model_});
  const Problem problem = fetch.whyNot(model_ + "/tip/files/a.dae");
  EXPECT_EQ(problem.text, "'" + model_ + "/tip/files/a.dae' can't be downloaded: the server has none");
  EXPECT_EQ(problem.hint, "look again");
}

TEST_F(FuelFetchTest, TellsWhereTheProgramEndsEarly) {
  FuelFetch silent = fetchBy("exit 1");
  silent.bring({model_});
  EXPECT_EQ(silent.whyNot(model_).text, "'" + model_ + "' can't be downloaded: the download ended without a result");
  FuelFetch killed = fetchBy("kill -9 $$");
  killed.bring({model_});
  EXPECT_EQ(killed.whyNot(model_).text, "'" + model_ + "' can't be downloaded: the download was interrupted");
  FuelFetch none({{}, folder_.path()}, "/no/such/program");
  none.bring({model_});
  EXPECT_EQ(none.whyNot(model_).text,
            "'" + model_ + "' can't be downloaded: /no/such/program can't be run: No such file or directory");
}

TEST_F(FuelFetchTest, AsksNothingOffline) {
  FuelFetch fetch = fetchBy("cat >>" + (folder_.path() / "asked").string());
  setenv("PONGSIM_OFFLINE", "1", 1);
  fetch.bring({model_});
  EXPECT_EQ(asked(), "");
  EXPECT_EQ(fetch.whyNot(model_).hint, "downloads are off: PONGSIM_OFFLINE or --offline is set");
}

}  // namespace
}  // namespace pongsim::assets
