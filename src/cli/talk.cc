#include "cli/talk.hh"

#include <string_view>

#include "cli/command.hh"
#include "cli/command_line.hh"

namespace pongsim::cli {

namespace {

constexpr AddCommand kTalkCommands[] = {addTopicCommand, addServiceCommand};

}  // namespace

bool isTalk(int argc, char** argv) {
  if (argc < 2) return false;
  const std::string_view command = argv[1];
  return command == "topic" || command == "service";
}

int talk(int argc, char** argv) { return run(argc, argv, kTalkCommands); }

}  // namespace pongsim::cli
