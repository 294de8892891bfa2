#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/cli.hh"
#include "support/temp_folder.hh"

namespace pongsim::cli {
namespace {

struct SdfOutcome {
  int exitCode;
  std::string output;
  std::string error;
};

SdfOutcome runSdf(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"pongsim", "sdf"});
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int exitCode = run(static_cast<int>(pointers.size()), pointers.data());
  return {exitCode, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

class SdfCheck : public testing::Test {
 protected:
  SdfOutcome check(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "--check");
    return runSdf(std::move(arguments));
  }

  std::string write(const std::string& name, const std::string& content) {
    return folder_.write(name, "<sdf version='1.9'>\n" + content + "</sdf>").string();
  }

  test::TempFolder folder_;
};

TEST_F(SdfCheck, SaysThatAFileIsValid) {
  const SdfOutcome outcome = check({write("a.sdf", "<world name='w'/>")});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.output, "Valid.\n");
  EXPECT_EQ(outcome.error, "");
}

TEST_F(SdfCheck, SaysWhatIsWrong) {
  const std::string file = write("a.sdf", "<world/>");
  const SdfOutcome outcome = check({file});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(outcome.error, file +
                               ":2:1: error: <world> has no name\n    <world/></sdf>\n    ^\n"
                               "  hint: write <world name=\"...\">\n");
}

TEST_F(SdfCheck, NamesTheFilesWhereThereAreSeveral) {
  const std::string good = write("a.sdf", "<world name='w'/>");
  const std::string bad = write("b.sdf", "<world/>");
  const SdfOutcome outcome = check({good, bad, "/no/such.sdf", good});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.output, good + ": Valid.\n" + good + ": Valid.\n");
  EXPECT_NE(outcome.error.find(bad + ":2:1: error: "), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("/no/such.sdf: error: no such file"), std::string::npos) << outcome.error;
}

TEST_F(SdfCheck, TakesWarningsForErrorsIfItIsStrict) {
  const std::string file = write("a.sdf", "<world name='w'><odd/></world>");
  EXPECT_EQ(check({file}).exitCode, 0);
  EXPECT_EQ(check({file}).output, "Valid.\n");
  const SdfOutcome outcome = check({file, "--strict"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.output, "");
  EXPECT_TRUE(outcome.error.starts_with(file + ":2:17: error: <odd> is unknown in <world>")) << outcome.error;
}

TEST_F(SdfCheck, PrintsJson) {
  const std::string good = write("a.sdf", "<world name='w'/>");
  EXPECT_EQ(check({"--json", good}).output, "[]\n");
  const std::string bad = write("b.sdf", "<world/>");
  const SdfOutcome outcome = check({"--json", good, bad});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(outcome.output, "[{\"file\":\"" + bad +
                                "\",\"line\":2,\"column\":1,\"severity\":\"error\",\"message\":\"<world> has no name\","
                                "\"hint\":\"write <world name=\\\"...\\\">\"}]\n");
}

TEST(SdfCommand, DoesOneThingAtATime) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"--check"},
                                                    {"--check", "a.sdf", "--describe", "joint"},
                                                    {"--describe", "joint", "a.sdf"},
                                                    {"--describe", "joint", "--json"},
                                                    {"--describe", "joitn"}}) {
    const SdfOutcome outcome = runSdf(arguments);
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(outcome.error.starts_with("pongsim: error: ")) << outcome.error;
  }
}

TEST(SdfPrint, PrintsAFileWithWhatItIncludes) {
  const test::TempFolder folder;
  const std::string model =
      folder.write("m.sdf", "<sdf version='1.6'><model name='m'><link name='l'/></model></sdf>").string();
  const std::string world = folder
                                .write("w.sdf", "<sdf version='1.8'><world name='w'><include><uri>" + model +
                                                    "</uri><pose>1 0 0 0 0 0</pose></include><odd/></world></sdf>")
                                .string();
  const SdfOutcome outcome = runSdf({"--print", world});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.error.find("<odd> is unknown"), std::string::npos) << outcome.error;
  EXPECT_EQ(outcome.output,
            "<?xml version=\"1.0\"?>\n"
            "<sdf version=\"1.9\">\n"
            "  <world name=\"w\">\n"
            "    <model name=\"m\">\n"
            "      <link name=\"l\"/>\n"
            "      <pose>1 0 0 0 0 0</pose>\n"
            "    </model>\n"
            "    <odd/>\n"
            "    <gravity>0 0 -9.8</gravity>\n"
            "    <magnetic_field>5.5645e-6 22.8758e-6 -42.3884e-6</magnetic_field>\n"
            "    <atmosphere type=\"adiabatic\"/>\n"
            "    <physics type=\"ode\">\n"
            "      <max_step_size>0.001</max_step_size>\n"
            "      <real_time_factor>1.0</real_time_factor>\n"
            "      <real_time_update_rate>1000</real_time_update_rate>\n"
            "    </physics>\n"
            "    <scene>\n"
            "      <ambient>0.4 0.4 0.4 1.0</ambient>\n"
            "      <background>.7 .7 .7 1</background>\n"
            "      <shadows>true</shadows>\n"
            "    </scene>\n"
            "  </world>\n"
            "</sdf>\n");
}

TEST(SdfPrint, PrintsNothingOfAFileWithErrors) {
  const SdfOutcome outcome = runSdf({"--print", "/no/such.sdf"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(outcome.error.substr(0, 40), "/no/such.sdf: error: no such file\n  hint");
  EXPECT_EQ(runSdf({"--print", "a.sdf", "b.sdf"}).exitCode, 2);
}

/// A world at an angle, with a model that it includes.
class SdfPrintOptions : public testing::Test {
 protected:
  std::string print(std::vector<std::string> options) {
    options.insert(options.begin(), {"--print", world_});
    const SdfOutcome outcome = runSdf(options);
    EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
    return outcome.output;
  }

  test::TempFolder folder_;
  std::string model_ =
      folder_.write("m.sdf", "<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>").string();
  std::string world_ = folder_.write("w.sdf", "<sdf version='1.9'><world name='w'><include><uri>" + model_ +
                                                  "</uri><pose>1 2 3 0 0 1.57</pose></include></world></sdf>");
};

TEST_F(SdfPrintOptions, LeaveIncludesAsTheyStand) {
  EXPECT_EQ(print({}).find("<include>"), std::string::npos);
  const std::string text = print({"-i"});
  EXPECT_NE(text.find("<uri>" + model_ + "</uri>"), std::string::npos) << text;
  EXPECT_EQ(text.find("<link"), std::string::npos) << text;
}

TEST_F(SdfPrintOptions, TurnRotationsToDegrees) {
  EXPECT_NE(print({}).find("<pose>1 2 3 0 0 1.57</pose>"), std::string::npos) << print({});
  EXPECT_NE(print({"--degrees"}).find(">1 2 3   0 0 89.9544</pose>"), std::string::npos) << print({"--degrees"});
  const std::string snapped = print({"--snap-to-degrees", "45", "--snap-tolerance", "0.1"});
  EXPECT_NE(snapped.find("degrees=\"true\" rotation_format=\"euler_rpy\">1 2 3   0 0 90</pose>"), std::string::npos)
      << snapped;
}

TEST_F(SdfPrintOptions, TellOfAModelsInertia) {
  const SdfOutcome stats = runSdf({"--inertial-stats", model_});
  EXPECT_EQ(stats.exitCode, 0) << stats.error;
  EXPECT_TRUE(stats.output.starts_with("Inertial statistics for model: m\n---\nTotal mass of the model: 1\n"))
      << stats.output;
  const SdfOutcome world = runSdf({"--inertial-stats", world_});
  EXPECT_EQ(world.exitCode, 1);
  EXPECT_EQ(world.error, "pongsim: error: '" + world_ + "' has a world\n  hint: --inertial-stats needs a model file\n");
}

TEST(SdfGraph, PrintsText) {
  const test::TempFolder folder;
  const std::string world = folder.write("w.sdf", "<sdf version='1.8'><world name='w'/></sdf>").string();
  const SdfOutcome outcome = runSdf({"--graph", "frame", world});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.output, "digraph {\n  0 [label=\"world\"];\n}\n");
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(runSdf({"--graph", "frames", world}).exitCode, 2);
  EXPECT_EQ(runSdf({"--graph", "pose"}).exitCode, 2);
  EXPECT_EQ(runSdf({"--graph", "pose", "/no/such.sdf"}).exitCode, 1);
}

TEST(SdfDescribe, PrintsWhatTheFormatSays) {
  const SdfOutcome outcome = runSdf({"--describe", "//joint/axis/limit"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.error, "");
  EXPECT_TRUE(outcome.output.starts_with("<limit> in joint/axis\n")) << outcome.output;
  const SdfOutcome all = runSdf({"-d"});
  EXPECT_EQ(all.exitCode, 0) << all.error;
  EXPECT_TRUE(all.output.starts_with("<element name ='sdf' required ='1'>\n")) << all.output.substr(0, 200);
  EXPECT_EQ(runSdf({"-d", "1.9"}).output, all.output);
  EXPECT_EQ(runSdf({"-d", "1.3"}).exitCode, 2);
  EXPECT_NE(runSdf({"-d", "1.12"}).output.find("<element name ='cone'"), std::string::npos);
  EXPECT_EQ(runSdf({"-d", "1.13"}).exitCode, 2);
}

}  // namespace
}  // namespace pongsim::cli
