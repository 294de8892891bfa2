// pongsim-log, which `pongsim log` runs.
#include "log/command/command.hh"

namespace {

constexpr pongsim::programs::AddAction kActions[] = {
    pongsim::log::addRecordAction, pongsim::log::addInfoAction,     pongsim::log::addConvertAction,
    pongsim::log::addExportAction, pongsim::log::addPlaybackAction, pongsim::log::addWorldAction,
};

constexpr pongsim::programs::Program kProgram{
    .name = "pongsim log",
    .about = "Records topics; plays, inspects, converts and exports recordings.",
    .actions = kActions};

}  // namespace

int main(int argc, char** argv) { return pongsim::programs::run(argc, argv, kProgram); }
