#include "fuel/command.hh"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <optional>
#include <system_error>

#include "fuel/actions.hh"
#include "fuel/failure.hh"

namespace pongsim::fuel {

namespace {

using Action = int (*)(const Options&);
/// The options of an action, filled in by CLI11.
using Given = std::shared_ptr<Options>;

void checkHeaders(const std::vector<std::string>& headers) {
  for (const std::string& header : headers) {
    const std::size_t colon = header.find(':');
    if (colon == 0 || colon == std::string::npos || header.find_first_of("\r\n") != std::string::npos) {
      throw UsageError("'" + header + "' is not a header", "write --header 'Private-Token: TOKEN'");
    }
  }
}

/// @return A function that runs an action with the options that `given` contains by then.
cli::Work workOf(Action action, const Given& given) {
  return [action, given] {
    checkHeaders(given->headers);
    if (given->offline) setenv("PONGSIM_OFFLINE", "1", 1);
    return action(*given);
  };
}

CLI::App* addAction(CLI::App& program, cli::Work& work, const char* name, const char* help, Action action,
                    const Given& given) {
  CLI::App* command = program.add_subcommand(name, help);
  command
      ->add_option("-c,--config", given->config,
                   "Configuration with servers, tokens and cache (~/.ignition/fuel/config.yaml)")
      ->type_name("FILE");
  command
      ->add_option_function<std::string>(
          "-v,--verbose",
          [given](const std::string& text) {
            // "-v" without a number, as in Fortress
            if (text.empty()) return;
            if (text.size() != 1 || text[0] < '0' || text[0] > '4') {
              throw UsageError("option '-v' takes a level from 0 to 4, not '" + text + "'");
            }
            given->verbosity = text[0] - '0';
          },
          "Verbosity: 1 errors, 2 warnings, 3 progress (3)")
      ->type_name("LEVEL")
      ->expected(0, 1);
  command->callback([action, given, &work] { work = workOf(action, given); });
  return command;
}

void addAddress(CLI::App& command, const Given& given, bool isMany) {
  auto* positional =
      command.add_option("ADDRESS", given->addresses, "https://fuel.gazebosim.org/1.0/OWNER/models/NAME")
          ->type_name("");
  if (!isMany) positional->expected(0, 1);
  command.add_option("-u,--url", given->url, "The address, like 'ign fuel'")->type_name("URL");
}

void addHeader(CLI::App& command, const Given& given) {
  command.add_option("--header", given->headers, "A header for requests, such as 'Private-Token: TOKEN'")
      ->type_name("TEXT")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void addOffline(CLI::App& command, const Given& given) {
  command.add_flag("--offline", given->offline, "Use no network, like PONGSIM_OFFLINE=1");
}

void addJobs(CLI::App& command, const Given& given) {
  command
      .add_option_function<std::string>(
          "-j,--jobs",
          [given](const std::string& text) {
            std::size_t jobs = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), jobs);
            if (error != std::errc() || end != text.data() + text.size() || jobs < 1 || jobs > 16) {
              throw UsageError("option '-j' takes a number from 1 to 16, not '" + text + "'");
            }
            given->jobs = jobs;
          },
          "Parallel downloads, 1 to 16 (4)")
      ->type_name("N");
}

}  // namespace

void addActions(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<Options>();
  const auto add = [&](const char* name, const char* help, Action action) {
    return addAction(program, work, name, help, action, given);
  };
  CLI::App* list = add("list", "List the models or worlds of a server, or of the cache", actions::list);
  list->add_option("-t,--type", given->type, "What to list")->type_name("model|world");
  list->add_option("-o,--owner", given->owner, "Those of one owner")->type_name("OWNER");
  list->add_option("-u,--url", given->url, "The server (those of the configuration, else https://fuel.gazebosim.org)")
      ->type_name("URL");
  list->add_flag("-r,--raw", given->raw, "Print addresses, one per line");
  list->add_flag("--cached", given->cached, "List the cache");
  addHeader(*list, given);
  addOffline(*list, given);

  CLI::App* info = add("info", "Describe a model or world, on its server and in the cache", actions::info);
  addAddress(*info, given, false);
  info->add_flag("--cached", given->cached, "Only from the cache");
  addHeader(*info, given);
  addOffline(*info, given);

  CLI::App* download =
      add("download", "Download models, worlds or collections into the cache, with everything they refer to",
          actions::download);
  addAddress(*download, given, true);
  download->add_option("-t,--type", given->type, "Only these of a collection")->type_name("model|world");
  addJobs(*download, given);
  addHeader(*download, given);
  addOffline(*download, given);

  CLI::App* remove = add("delete", "Delete a model or world from its server, or from the cache", actions::remove);
  addAddress(*remove, given, false);
  remove->add_flag("--cached", given->cached, "From the cache");
  addHeader(*remove, given);
  addOffline(*remove, given);

  CLI::App* update = add("update", "Update everything in the cache to the newest version", actions::update);
  update->add_flag("--onlymodels", given->onlyModels, "Models only");
  update->add_flag("--onlyworlds", given->onlyWorlds, "Worlds only")->excludes("--onlymodels");
  addJobs(*update, given);
  addHeader(*update, given);

  add("check", "Report broken entries in the cache", actions::check);
  add("fetch", "", actions::fetch)->group("");
}

std::vector<std::string> checkedWords(std::vector<std::string> words, const CLI::App&) {
  const std::string& action = words.front();
  const auto refuse = [&](const std::string& instead) {
    throw UsageError("'" + action + "' is not supported", instead);
  };
  if (action == "upload" || action == "edit") refuse("use https://app.gazebosim.org or 'ign fuel " + action + "'");
  if (action == "configure") refuse("write ~/.ignition/fuel/config.yaml, as docs/fuel.md describes");
  if (action == "meta") refuse("use 'ign fuel meta'; pongsim reads model.config as it is");
  return words;
}

}  // namespace pongsim::fuel
