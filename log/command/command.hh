#pragma once

#include <functional>
#include <span>

namespace CLI {
class App;
}

namespace pongsim::log {

/// What is to be done once the command line has been read.
/// @return The exit code.
using Work = std::function<int()>;

/// Adds an action of `pongsim log` to `program`, which sets `work` where the user names it; both must stay until the
/// work is done.
using AddAction = void (*)(CLI::App& program, Work& work);

// Each stands in the list in main.cc, too, and in share/log.json for help and completion.
void addPlaybackAction(CLI::App& program, Work& work);
void addWorldAction(CLI::App& program, Work& work);
void addConvertAction(CLI::App& program, Work& work);
void addExportAction(CLI::App& program, Work& work);
void addInfoAction(CLI::App& program, Work& work);
void addRecordAction(CLI::App& program, Work& work);

}  // namespace pongsim::log
