#include "security/command.hh"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "security/actions.hh"
#include "shared/program/failure.hh"

namespace pongsim::security {

namespace {

using Given = std::shared_ptr<Options>;

CLI::App* addAction(CLI::App& program, cli::Work& work, const char* name, const char* help,
                    int (*action)(const Options&), const Given& given) {
  CLI::App* command = program.add_subcommand(name, help);
  command->callback([action, given, &work] { work = [action, given] { return action(*given); }; });
  return command;
}

void addDays(CLI::App& command, const Given& given, const char* help) {
  command
      .add_option_function<std::string>(
          "--days",
          [given](const std::string& text) {
            constexpr int kMost = 36500;
            int days = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), days);
            if (error != std::errc() || end != text.data() + text.size() || days < 1 || days > kMost) {
              throw cli::UsageError("option '--days' takes a number from 1 to 36500, not '" + text + "'");
            }
            given->days = days;
          },
          help)
      ->type_name("N");
}

void addKeystore(CLI::App& command, const Given& given) {
  command
      .add_option("-k,--keystore", given->keystore,
                  "The keystore (that of PONGSIM_SECURITY or ROS_SECURITY_KEYSTORE, else ./keystore)")
      ->type_name("FOLDER");
}

void addPermission(CLI::App& command, const char* name, std::vector<std::string>& patterns, const char* what,
                   const char* help) {
  command.add_option(name, patterns, help)
      ->type_name(what)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void addPermissions(CLI::App& command, const Given& given) {
  addPermission(command, "--allow-publish", given->permissions.publish, "TOPIC",
                "May publish there: /cmd_vel or '/robot/*'; repeatable");
  addPermission(command, "--allow-subscribe", given->permissions.subscribe, "TOPIC", "May subscribe there");
  addPermission(command, "--allow-call", given->permissions.call, "SERVICE", "May call that service");
  addPermission(command, "--allow-offer", given->permissions.offer, "SERVICE", "May offer that service");
  CLI::Option* file = command
                          .add_option("--permissions", given->permissionsFile,
                                      "What it may do: DDS-Security permissions in XML, to be signed")
                          ->type_name("FILE");
  for (const char* each : {"--allow-publish", "--allow-subscribe", "--allow-call", "--allow-offer"}) {
    file->excludes(each);
  }
  command.footer(
      "Without any of these it may do everything; with one or more, only what they allow, also in ROS 2.\n"
      "Examples:\n"
      "  pongsim security add robot\n"
      "  pongsim security add driver --allow-publish /cmd_vel --days 30\n"
      "  pongsim security add viewer --keystore keys --allow-subscribe '*'");
}

}  // namespace

void addActions(CLI::App& program, cli::Work& work) {
  const auto given = std::make_shared<Options>();
  CLI::App* made =
      addAction(program, work, "init",
                "Create a keystore: a certificate authority and the identity 'pongsim', which may do everything",
                actions::init, given);
  made->add_option("FOLDER", given->keystore, "The new folder (keystore)")->type_name("");
  addDays(*made, given, "Validity of the authority in days (3650); the identity 'pongsim' is valid for at most 365");

  CLI::App* added = addAction(program, work, "add", "Add an identity to a keystore", actions::add, given);
  added->add_option("NAME", given->name, "The name, such as robot or fleet/robot_1")->type_name("")->required();
  addKeystore(*added, given);
  addDays(*added, given, "Validity in days (365), at most the authority's");
  addPermissions(*added, given);

  CLI::App* listed = addAction(program, work, "list",
                               "List all identities: subject, validity and permissions; exit code 1\n"
                               "if one can't be used",
                               actions::list, given);
  listed->add_option("FOLDER", given->keystore, "The keystore, as with add")->type_name("");
  listed->add_flag("--json", given->asJson, "Print JSON: an array of objects")->disable_flag_override();
}

}  // namespace pongsim::security
