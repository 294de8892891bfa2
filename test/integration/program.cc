#include "integration/program.hh"

#include <gtest/gtest.h>

#include <sstream>

#include "support/fortress_worlds.hh"
#include "support/test_domain.hh"

namespace pongsim::test {

std::unique_ptr<Process> start(std::vector<std::string> arguments) {
  testDomain();
  arguments.insert(arguments.begin(), PONGSIM_PROGRAM);
  return std::make_unique<Process>(arguments);
}

Outcome runToEnd(std::vector<std::string> arguments) {
  const std::unique_ptr<Process> process = start(std::move(arguments));
  const int exitCode = process->wait().value_or(-1);
  return {exitCode, process->output(), process->error()};
}

std::unique_ptr<Process> startWorld(const std::string& name, std::vector<std::string> options) {
  options.insert(options.begin(), {"run", ownWorld(name)});
  std::unique_ptr<Process> process = start(std::move(options));
  EXPECT_TRUE(process->waitForError("pongsim: world '")) << process->error();
  return process;
}

std::unique_ptr<Process> startServedWorld(const std::string& name, std::vector<std::string> options) {
  std::unique_ptr<Process> process = startWorld(name, std::move(options));
  EXPECT_EQ(runToEnd({"topic", "-et", "/clock", "-n", "1"}).exitCode, 0);
  return process;
}

std::string ownWorld(const std::string& name) { return (projectFolder() / "worlds" / name).string(); }

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

}  // namespace pongsim::test
