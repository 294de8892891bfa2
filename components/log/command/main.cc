// pongsim-log, which `pongsim log` runs.
#include "log/command/command.hh"

namespace {

constexpr pongsim::cli::AddCommand kActions[] = {
    pongsim::log::addRecordAction, pongsim::log::addInfoAction,     pongsim::log::addConvertAction,
    pongsim::log::addExportAction, pongsim::log::addPlaybackAction, pongsim::log::addWorldAction,
};

constexpr pongsim::cli::Program kProgram{.name = "pongsim log",
                                         .about = "Records topics; plays, inspects, converts and exports recordings.",
                                         .commands = kActions};

}  // namespace

int main(int argc, char** argv) { return pongsim::cli::run(argc, argv, kProgram); }
