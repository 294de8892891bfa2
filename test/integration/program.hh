#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/process.hh"

namespace pongsim::test {

/// How a process ended; `exitCode` is -1 if it had to be killed.
struct Outcome {
  int exitCode = -1;
  std::string output;
  std::string error;
};

/// Starts the program `pongsim` in this test's own DDS domain.
std::unique_ptr<Process> start(std::vector<std::string> arguments);

/// Runs the program until it ends.
Outcome runToEnd(std::vector<std::string> arguments);

/// Starts one of the project's own worlds, and waits until it is loaded and runs.
std::unique_ptr<Process> startWorld(const std::string& name, std::vector<std::string> options = {});

/// Like `startWorld`, but also waits until its topics and services are there.
std::unique_ptr<Process> startServedWorld(const std::string& name, std::vector<std::string> options = {});

/// @return The full path of one of the project's own worlds.
std::string ownWorld(const std::string& name);

/// @return The lines of a text.
std::vector<std::string> lines(const std::string& text);

}  // namespace pongsim::test
