#pragma once

#include <string>
#include <vector>

#include "shared/program/command_line.hh"

namespace pongsim::ros2 {

// The actions of `pongsim ros2` (`cli::AddCommand`), which main.cc lists.
void addCheckAction(CLI::App& program, cli::Work& work);
void addCreateAction(CLI::App& program, cli::Work& work);
void addDoctorAction(CLI::App& program, cli::Work& work);
void addNodesAction(CLI::App& program, cli::Work& work);
void addTopicsAction(CLI::App& program, cli::Work& work);

/// @return The words of a command line, in which those of `create` have two dashes, because ros_gz_sim's have one.
std::vector<std::string> withTwoDashesForCreate(std::vector<std::string> words, const CLI::App& program);

}  // namespace pongsim::ros2
