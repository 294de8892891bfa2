// pongsim-fuel, which `pongsim fuel` runs.
#include "fuel/command.hh"
#include "shared/program/stop_signal.hh"

namespace {

constexpr pongsim::cli::AddCommand kActions[] = {pongsim::fuel::addActions};

constexpr pongsim::cli::Program kProgram{
    .name = "pongsim fuel",
    .about = "List, download and manage models and worlds from Fuel servers, in a cache shared with Fortress",
    .commands = kActions,
    .footer =
        "Examples:\n"
        "  pongsim fuel list -t model -o OpenRobotics\n"
        "  pongsim fuel download -u https://fuel.gazebosim.org/1.0/OpenRobotics/models/Ambulance\n"
        "  pongsim fuel check",
    .words = pongsim::fuel::checkedWords,
};

}  // namespace

int main(int argc, char** argv) {
  pongsim::cli::takeStopSignals();
  return pongsim::cli::run(argc, argv, kProgram);
}
