#include <cstdio>
#include <string>
#include <variant>

#include "base/report/terminate_handler.hh"
#include "base/shared_library.hh"
#include "cli/own_folder.hh"
#include "cli/talk.hh"
#include "msgs/types/described_types.hh"

namespace pongsim::msgs {

const TypeSource& typeSource() {
  static const DescribedTypes types(cli::ownFolder() / "message_types");
  return types.source();
}

}  // namespace pongsim::msgs

namespace {

using pongsim::base::SharedLibrary;

/// All other commands are in the library, which is opened for them.
int runWhole(int argc, char** argv) {
  const auto opened = SharedLibrary::open(PONGSIM_LIBRARY);
  if (const auto* why = std::get_if<std::string>(&opened)) {
    std::fprintf(stderr, "pongsim: error: %s\n", why->c_str());
    return 1;
  }
  auto* const whole = std::get<SharedLibrary>(opened).find<int(int, char**)>("pongsim_main");
  if (whole == nullptr) {
    std::fputs("pongsim: error: " PONGSIM_LIBRARY " has a different version\n", stderr);
    return 1;
  }
  return whole(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  pongsim::base::installTerminateHandler();
  return pongsim::cli::isTalk(argc, argv) ? pongsim::cli::talk(argc, argv) : runWhole(argc, argv);
}
