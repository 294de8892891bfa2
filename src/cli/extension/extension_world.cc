#include "cli/extension/extension_world.hh"

#include <sys/wait.h>

#include <filesystem>
#include <utility>

#include "base/child_process.hh"
#include "cli/own_folder.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

std::optional<std::string> printedWorld(const Extension::WorldSource& source) {
  const std::filesystem::path program = ownFolder().parent_path().parent_path() / "libexec/pongsim" / source.program;
  Outcome<base::ChildResult> done = base::runChild(program, source.arguments);
  if (!done) {
    fail(done.error);
    return std::nullopt;
  }
  if (!WIFEXITED(done->status) || WEXITSTATUS(done->status) != 0) return std::nullopt;
  return std::move(done->output);
}

}  // namespace pongsim::cli
