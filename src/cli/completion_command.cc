#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <utility>

#include "cli/command.hh"
#include "cli/console.hh"

namespace pongsim::cli {

namespace {

/// What stands in the shell's function for every command alike; the rest is put in for the three marks.
constexpr const char* kBash = R"sh(# Completion of pongsim: source <(pongsim completion bash)
_pongsim() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} choices=
  if [ "$COMP_CWORD" -eq 1 ]; then
    choices='@COMMANDS@'
  else
    case $before in
      -t | --topic | -et | -it) choices=$("${COMP_WORDS[0]}" topic -l 2>/dev/null) ;;
      -s | --service | -is) choices=$("${COMP_WORDS[0]}" service -l 2>/dev/null) ;;
      -m | --msgtype | --reqtype | --reptype) choices=$("${COMP_WORDS[0]}" msg -l 2>/dev/null) ;;
      *)
        case ${COMP_WORDS[1]} in
@CASES@        esac
        [[ $word == -* ]] || choices+=" $(compgen -f -- "$word")"
        ;;
    esac
  fi
  local IFS=$' \t\n'
  COMPREPLY=($(compgen -W "$choices" -- "$word"))
}
complete -o filenames -F _pongsim pongsim
)sh";

constexpr const char* kZsh = "autoload -Uz +X compinit bashcompinit && compinit -u && bashcompinit\n";

void replace(std::string& text, std::string_view mark, std::string_view by) {
  text.replace(text.find(mark), mark.size(), by);
}

/// @return The names of a command's options.
std::string wordsOf(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_snames()) words += " -" + name;
    for (const std::string& name : option->get_lnames()) words += " --" + name;
  }
  return words.substr(words.empty() ? 0 : 1);
}

std::string script(const CLI::App& program, bool isZsh) {
  std::string commands, cases;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    commands += command->get_name() + " ";
    cases += "          " + command->get_name() + ") choices='" + wordsOf(*command) + "' ;;\n";
  }
  commands += wordsOf(program);
  std::string text = kBash;
  replace(text, "@COMMANDS@", commands);
  replace(text, "@CASES@", cases);
  return (isZsh ? kZsh : "") + text;
}

}  // namespace

void addCompletionCommand(CLI::App& program, Work& work) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("completion", "Print what makes a shell complete pongsim's words");
  command->set_help_flag("-h,--help", "Print this and end");
  command->add_option("SHELL", *shell, "bash or zsh")->type_name("");
  command->footer(
      "Examples:\n"
      "  source <(pongsim completion bash)\n"
      "  pongsim completion zsh");
  command->callback([&program, shell, &work] {
    if (*shell != "bash" && *shell != "zsh") {
      throw UsageError(shell->empty() ? "no shell given" : "no completion for '" + *shell + "'", "bash or zsh");
    }
    work = [text = script(program, *shell == "zsh")] { return print(text) ? kDone : kFailed; };
  });
}

}  // namespace pongsim::cli
