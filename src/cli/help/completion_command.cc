#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "cli/command.hh"
#include "cli/extension/extension_command.hh"
#include "shared/program/console.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// The part of the shell function that is the same for all commands; the three marks are replaced.
constexpr const char* kBash = R"sh(# Completion of pongsim: source <(pongsim completion bash)
# What packages installed beside pongsim add, asked for once.
_pongsim_extensions() {
  [ -n "${_pongsim_extension_words+set}" ] || _pongsim_extension_words=$("$1" completion words 2>/dev/null)
  printf '%s\n' "$_pongsim_extension_words"
}
_pongsim() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} choices=
  local program=${COMP_WORDS[0]} command=${COMP_WORDS[1]}
  if [ "$COMP_CWORD" -eq 1 ]; then
    choices='@COMMANDS@'
    choices+=" $(_pongsim_extensions "$program" | cut -d ' ' -f 1)"
  else
    case $command/$before in
      topic/-t | topic/--topic | topic/-et | topic/-it | key/-t | key/--topic)
        choices=$("$program" topic -l 2>/dev/null) ;;
      service/-s | service/--service | service/-is) choices=$("$program" service -l 2>/dev/null) ;;
      topic/-m | topic/--msgtype | service/--reqtype | service/--reptype | msg/-[it] | msg/--info | msg/--template)
        choices=$("$program" msg -l 2>/dev/null) ;;
      model/-m | model/--model) choices=$("$program" model --list 2>/dev/null | sed -n 's/^ *- //p') ;;
      */-w | */--world)
        choices=$("$program" service -l 2>/dev/null | sed -n 's|^/world/\([^/]*\)/control$|\1|p') ;;
      *)
        case $command in
@CASES@        esac
        choices+=" $(_pongsim_extensions "$program" | sed -n "s/^$command //p")"
        [[ $word == -* ]] || choices+=" $(compgen -f -- "$word")"
        ;;
    esac
  fi
  local IFS=$' \t\n'
  COMPREPLY=($(compgen -W "$choices" -- "$word"))
}
complete -o filenames -F _pongsim pongsim
)sh";

/// Before and after it for zsh, which loads the script either with `source`, or as the function _pongsim from a file
/// with that name in a completion folder: then the function must also do the completion it was called for.
constexpr const char* kZsh = R"sh(#compdef pongsim
if [[ ${funcstack[1]} != _pongsim ]]; then autoload -Uz +X compinit && compinit -u; fi
autoload -Uz +X bashcompinit && bashcompinit
)sh";
constexpr const char* kZshEnd =
    R"sh(if [[ ${funcstack[1]} == _pongsim ]]; then _bash_complete -o filenames -F _pongsim; fi
)sh";

void replace(std::string& text, std::string_view mark, std::string_view by) {
  text.replace(text.find(mark), mark.size(), by);
}

/// Plain words that can follow a command.
constexpr std::pair<std::string_view, std::string_view> kActionWords[] = {
    {"topic", "wait"}, {"world", "pause play step reset stats info"}, {"plugin", "new"}, {"completion", "bash zsh"}};

/// @return The names of a command's options.
std::string wordsOf(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : command.get_options()) {
    // options without a group are hidden from the help
    if (option->get_group() == kExtensionGroup || option->get_group().empty()) continue;
    for (const std::string& name : option->get_snames()) words += " -" + name;
    for (const std::string& name : option->get_lnames()) words += " --" + name;
  }
  return words.substr(words.empty() ? 0 : 1);
}

std::string script(const CLI::App& program, bool isZsh) {
  std::string commands, cases;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_group() == kExtensionGroup) continue;
    commands += command->get_name() + " ";
    std::string words = wordsOf(*command);
    for (const auto& [name, actions] : kActionWords) {
      if (name == command->get_name()) words += " " + std::string(actions);
    }
    cases += "          " + command->get_name() + ") choices='" + words + "' ;;\n";
  }
  commands += wordsOf(program);
  std::string text = kBash;
  replace(text, "@COMMANDS@", commands);
  replace(text, "@CASES@", cases);
  return isZsh ? kZsh + text + kZshEnd : text;
}

}  // namespace

void addCompletionCommand(CLI::App& program, Work& work) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("completion", "Print the script for shell completion");
  command->add_option("SHELL", *shell, "bash or zsh")->type_name("");
  command->footer(
      "Examples:\n"
      "  source <(pongsim completion bash)\n"
      "  pongsim completion zsh");
  command->callback([&program, shell, &work] {
    // called by the script
    if (*shell == "words") {
      work = [] { return print(extensionWords()) ? kDone : kFailed; };
      return;
    }
    if (*shell != "bash" && *shell != "zsh") {
      throw UsageError(shell->empty() ? "no shell given" : "no completion for '" + *shell + "'", "bash or zsh");
    }
    work = [text = script(program, *shell == "zsh")] { return print(text) ? kDone : kFailed; };
  });
}

}  // namespace pongsim::cli
