// pongsim-security, which `pongsim security` runs.
#include "security/command.hh"
#include "shared/program/command_line.hh"

namespace {

constexpr pongsim::cli::AddCommand kActions[] = {pongsim::security::addActions};

constexpr pongsim::cli::Program kProgram{
    .name = "pongsim security",
    .about = "Creates and lists keystores, which secure topics and services.",
    .commands = kActions,
    .footer =
        "Examples:\n"
        "  pongsim security init keys\n"
        "  pongsim run worlds/pong_world.sdf --secure keys\n"
        "  pongsim security add robot --keystore keys --allow-publish /cmd_vel\n"
        "  pongsim topic -t /cmd_vel -m Twist -p 'linear: {x: 1}' --secure keys/robot\n"
        "  pongsim security list keys"};

}  // namespace

int main(int argc, char** argv) { return pongsim::cli::run(argc, argv, kProgram); }
