// pongsim-log, which `pongsim log` becomes.
#include "log/command/command.hh"
#include "log/command/command_line.hh"

namespace {

constexpr pongsim::log::AddAction kActions[] = {
    pongsim::log::addRecordAction, pongsim::log::addInfoAction,     pongsim::log::addConvertAction,
    pongsim::log::addExportAction, pongsim::log::addPlaybackAction, pongsim::log::addWorldAction,
};

}  // namespace

int main(int argc, char** argv) { return pongsim::log::run(argc, argv, kActions); }
