#include "cli/cli.hh"

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "support/regex.hh"
#include "support/test_domain.hh"

namespace pongsim::cli {
namespace {

struct Outcome {
  int exitCode;
  std::string output;
  std::string error;
};

/// Runs the program with command lines that neither simulate nor communicate.
Outcome runWith(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "pongsim");
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int exitCode = run(static_cast<int>(pointers.size()), pointers.data());
  return {exitCode, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

struct Case {
  std::vector<std::string> arguments;
  /// The message without "pongsim: error: ", and the hint after " | ".
  const char* error;
};

std::ostream& operator<<(std::ostream& stream, const Case& each) {
  for (const std::string& argument : each.arguments) stream << argument << " ";
  return stream;
}

class WrongCommandLine : public testing::TestWithParam<Case> {};

TEST_P(WrongCommandLine, IsRefusedWithExitCode2) {
  const std::string wanted = GetParam().error;
  const std::size_t bar = wanted.find(" | ");
  const std::string text = "pongsim: error: " + wanted.substr(0, bar) +
                           (bar == std::string::npos ? std::string() : "\n  hint: " + wanted.substr(bar + 3)) + "\n";
  const Outcome outcome = runWith(GetParam().arguments);
  EXPECT_EQ(outcome.error, text);
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(outcome.exitCode, 2);
}

const Case kWrong[] = {
    {{}, "no command given | pongsim --help lists the commands"},
    {{"rnu", "x.sdf"}, "unknown command 'rnu' | did you mean 'run'?"},
    {{"help", "topci"}, "unknown command 'topci' | did you mean 'topic'?"},
    {{"sdf", "a.sdf"}, "no action given | pongsim sdf --help lists the actions"},
    {{"sdf", "--check"}, "no file given | pongsim sdf --check FILE"},
    {{"launch", "a.ign"}, "pongsim does not run launch files | start the programs in a script: pongsim run WORLD &"},
    {{"gui", "-l"},
     "pongsim has no GUI | 'pongsim view' renders a world, 'pongsim topic -e --plot' what a sensor measures"},
    {{"gazebo", "-r", "a.sdf"}, "'gazebo' is 'run' here | pongsim run WORLD"},
    {{"topic", "--version"}, "'--version' can't be combined with other options | pongsim --version"},
    {{"run", "-g", "a.sdf"}, "'-g' is not supported: pongsim has no GUI | 'pongsim view' draws a running world"},
    {{"run", "--network-role", "primary", "a.sdf"},
     "one process runs the whole world: there is no '--network-role' | leave it out; '--threads' uses more cores, "
     "'--levels' loads only levels near performers"},
    {{"sdf", "-k", "-i", "a.sdf"},
     "--preserve-includes, --degrees, --snap-..., --precision and --expand-auto-inertials need --print"},
    {{"sdf", "-p", "--snap-tolerance", "1", "a.sdf"}, "--snap-tolerance needs --snap-to-degrees"},
    {{"sdf", "-p", "--snap-to-degrees", "1", "--snap-tolerance", "1", "a.sdf"},
     "--snap-tolerance must be smaller than --snap-to-degrees"},
    {{"sdf", "-p", "--snap-to-degrees", "361", "a.sdf"},
     "option '--snap-to-degrees' takes a whole number from 1 to 360, not '361'"},
    {{"sdf", "-d", "1.9", "a.sdf"}, "--describe takes no file"},
    {{"plugin", "-p", "a.so"}, "--plugin needs --info | pongsim plugin --info --plugin FILE"},
    {{"plugin", "-i"}, "no plugin given | pongsim plugin --info FILE|NAME"},
    {{"simulate"}, "unknown command 'simulate' | pongsim --help lists the commands"},
    {{"--versoin"}, "unknown option '--versoin' | did you mean '--version'?"},
    {{"run", "--pausd", "x.sdf"}, "unknown option '--pausd' | did you mean '--paused'?"},
    {{"run", "--pausd"}, "unknown option '--pausd' | did you mean '--paused'?"},
    {{"run", "--iteration=5", "x.sdf"}, "unknown option '--iteration' | did you mean '--iterations'?"},
    {{"run", "-q", "x.sdf"}, "unknown option '-q' | pongsim run --help lists the options"},
    {{"run", ""}, "no world file given | pongsim run WORLD"},
    {{"run", "-w", "maze"}, "option '-w' needs a world file | pongsim run FILE -w WORLD"},
    {{"run", "x.sdf", "-w", ""}, "option '-w' needs a world's name"},
    {{"run", "a.sdf", "b.sdf"}, "unexpected argument 'b.sdf'"},
    {{"run", "a.sdf", "topic"}, "unexpected argument 'topic'"},
    {{"run", "--iterations"}, "option '--iterations' needs a value"},
    {{"run", "--iterations", "-5", "x"}, "option '--iterations' takes a whole number from 0 to 2^64-1, not '-5'"},
    {{"run", "--seed", "1", "--seed", "2", "x"}, "option '--seed' is given twice"},
    {{"run", "-z", "nan", "x"}, "option '-z' takes a number of steps a second from 0, not 'nan'"},
    {{"run", "-z", "-1", "x"}, "option '-z' takes a number of steps a second from 0, not '-1'"},
    {{"run", "-v", "5", "x"}, "option '-v' takes a whole number from 0 to 4, not '5'"},
    {{"run", "-v", "x.sdf"}, "option '-v' takes a whole number from 0 to 4, not 'x.sdf'"},
    {{"run", "--paused=3", "x"}, "option '--paused' takes no value"},
    {{"run", "-r", "--paused", "x"}, "options '-r' and '--paused' can't be used together"},
    {{"model"}, "no action given | one of --list and --model NAME"},
    {{"model", "--list", "-m", "x"}, "only one action at a time | one of --list and --model NAME"},
    {{"model", "--list", "-l"}, "option '-l' can't be used with '--list' | use it with -m"},
    {{"model", "-m", ""}, "option '-m' needs a model's name"},
    {{"model", "-m", "x", "-n", "3"}, "option '-n' needs '--follow'"},
    {{"world", "stop"}, "unknown action 'stop' | did you mean 'step'?"},
    {{"world", "pause", "--json"}, "option '--json' can't be used with 'pause' | use it with stats and info"},
    {{"world", "play", "--seed", "1"}, "option '--seed' can't be used with 'play' | use it with reset"},
    {{"world", "reset", "--seed", "0"}, "option '--seed' takes a whole number from 1 to 4294967295, not '0'"},
    {{"view", ""}, "no world file given | pongsim view WORLD"},
    {{"view", "--at", "2"},
     "option '--at' can't be used here | use it with a world file: a running world is drawn as it is now"},
    {{"view", "x.sdf", "--timeout", "5"},
     "option '--timeout' can't be used here | use it without a file, with a running world"},
    {{"view", "-w", ""}, "option '-w' needs a world's name"},
    {{"view", "x.sdf", "--at", "-1"}, "option '--at' takes a number of seconds from 0, not '-1'"},
    {{"view", "--size", "10"}, "option '--size' takes WIDTHxHEIGHT, not '10'"},
    {{"topic", "-t", "/x", "-m", "Int32", "-p", "", "--json"},
     "option '--json' can't be used with '-p' | use it with -l, -i, -e, --hz, --bw or --delay"},
    {{"topic"},
     "no action given | one of --list, --info, --echo, --pub, --hz, --bw, --delay and wait; pongsim topic "
     "--help has details"},
    {{"topic", "-le"},
     "only one action at a time | one of --list, --info, --echo, --pub, --hz, --bw, --delay and wait; pongsim topic "
     "--help has details"},
    {{"topic", "-e"}, "'-e' needs a topic | -t TOPIC"},
    {{"topic", "-et"}, "option '--topic' needs a value"},
    {{"topic", "-lt", "/x"},
     "option '-t' can't be used with '-l' | use it with -i, -e, -p, --hz, --bw, --delay or wait"},
    {{"topic", "-it", "/x", "-n", "3"},
     "option '-n' can't be used with '-i' | use it with -e, -p, --hz, --bw or --delay"},
    {{"topic", "-it", "a b"}, "'a b' is not a topic name: it has a space"},
    {{"topic", "-et", "/x", "-n", "1", "-d", "1"}, "options '-n' and '-d' can't be used together"},
    {{"topic", "foo"}, "unexpected argument 'foo' | only 'wait' is allowed there"},
    {{"topic", "-et", "/x", "--csv", "--json-output"}, "options '--json' and '--csv' can't be used together"},
    {{"topic", "wait", "-t", "/x", "-n", "1"},
     "option '-n' can't be used with 'wait' | use it with -e, -p, --hz, --bw or --delay"},
    {{"topic", "wait", "-t", "/x", "--field", "data"},
     "'data' is not a condition on a field | write a path, a comparison (== != < <= > >=) and a value: "
     "'pose.position.x >= "
     "1'"},
    {{"topic", "-t", "/x", "-m", "Int32", "-p", "", "-n", "2"}, "'-n' with '-p' needs a rate | --rate HZ"},
    {{"topic", "-t", "/x", "-m", "Int32", "-p", "", "--rate", "0"}, "option '--rate' takes a number from 1e-6 to 1e6"},
    {{"topic", "-t", "/x", "-m", "Int32", "--file", "/no/such"}, "'/no/such' can't be read"},
    {{"topic", "-et", "/x", "-n", "0"}, "option '-n' takes a whole number from 1 to 2^64-1, not '0'"},
    {{"topic", "-et", "/x", "-d", "inf"}, "option '-d' takes a number of seconds from 0, not 'inf'"},
    {{"topic", "-et", "/x", "-m", "Odometri"},
     "unknown message type 'Odometri' | did you mean 'ignition.msgs.Odometry'?"},
    {{"topic", "-t", "/x", "-p", "data: 1"}, "'-p' needs the message's type | pongsim topic -t TOPIC -m TYPE -p TEXT"},
    {{"topic", "-t", "/x", "-m", "gz.msgs.Twist", "-p", "lineer: {}"},
     "message text:1:1: field 'lineer' is not in ignition.msgs.Twist\n  lineer: {}\n  ^ | did you mean 'linear'?"},
    {{"topic", "-t", "/x", "-m", "Int32", "-p", "-5"},
     "message text:1:1: a field's name expected here, not '-'\n  -5\n  ^"},
};
INSTANTIATE_TEST_SUITE_P(Cli, WrongCommandLine, testing::ValuesIn(kWrong));

TEST(Cli, PrintsItsVersionAndThoseOfItsLibraries) {
  const Outcome outcome = runWith({"--version"});
  EXPECT_EQ(outcome.exitCode, 0);
  const test::Regex wanted(
      "pongsim " PONGSIM_VERSION
      "\nBullet \\d\\.\\d\\d\nFast DDS \\d+\\.\\d+\\.\\d+\nEmbree \\d+\\.\\d+\\.\\d+\nMesa \\d+\\.\\d+\\.\\d+\n");
  EXPECT_TRUE(wanted.matches(outcome.output)) << outcome.output;
}

TEST(Cli, HelpsWithEachCommandAndShowsExamples) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--help"}, {"help"}, {"run", "--help"}, {"help", "run"}, {"topic", "-h"}}) {
    const Outcome outcome = runWith(arguments);
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.error, "");
    EXPECT_NE(outcome.output.find("Examples:\n  pongsim "), std::string::npos) << outcome.output;
  }
  EXPECT_NE(runWith({"help", "run"}).output.find("--iterations"), std::string::npos);
}

TEST(Cli, FailsWithTheReasonWhereThereIsNoSuchWorld) {
  test::testDomain();
  const Outcome outcome = runWith({"run", "/nowhere/missing.sdf"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.error.find("missing.sdf: error: "), std::string::npos) << outcome.error;
  EXPECT_TRUE(outcome.error.ends_with("pongsim: 1 error\n")) << outcome.error;
}

}  // namespace
}  // namespace pongsim::cli
