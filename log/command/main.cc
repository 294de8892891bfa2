// pongsim-log, which `pongsim log` becomes.
#include <span>

#include "log/command/command.hh"
#include "log/command/command_line.hh"

int main(int argc, char** argv) { return pongsim::log::run(argc, argv, std::span<const pongsim::log::AddAction>()); }
