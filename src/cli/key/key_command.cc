#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <CLI/App.hpp>
#include <array>
#include <cerrno>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/command.hh"
#include "cli/key/key_reader.hh"
#include "cli/key/key_terminal.hh"
#include "cli/look_around.hh"
#include "cli/options/network_option.hh"
#include "cli/options/number_option.hh"
#include "cli/options/secure_option.hh"
#include "cli/stop_signal.hh"
#include "cli/topic/topic_command.hh"
#include "cli/topic/topic_name.hh"
#include "msgs/control/control_messages.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "shared/program/console.hh"

namespace pongsim::cli {

namespace {

struct KeyOptions {
  std::string topic = "/keyboard/keypress";
  std::chrono::nanoseconds timeout = std::chrono::seconds(1);
  /// Print each key as JSON on stdout instead of in words on stderr.
  bool json = false;
};

/// Bytes that follow an escape within this time belong to it: a terminal sends a key's bytes at once.
constexpr int kSequenceMs = 50;

class Keyboard {
 public:
  explicit Keyboard(const KeyOptions& options)
      : options_(options), publisher_(transport_.node().advertise(options.topic, "ignition.msgs.Int32")) {}
  ~Keyboard() { close(stop_); }
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  int run();

 private:
  std::optional<std::string> readBytes();
  void send(const std::vector<Key>& keys);
  bool findListener(bool isTerminal);

  const KeyOptions& options_;
  // before the transport, whose threads inherit the signal mask
  StopSignal signal_;
  int stop_ = eventfd(0, EFD_CLOEXEC);
  Transport transport_;
  Publisher publisher_;
  KeyReader reader_;
};

int Keyboard::run() {
  const KeyTerminal terminal(STDIN_FILENO);
  const StopSignal::Callback stop(signal_, [this] { eventfd_write(stop_, 1); });
  if (terminal.isTerminal()) say("keys go to " + options_.topic + "; q or Ctrl-C quits");
  if (!findListener(terminal.isTerminal())) return kFailed;

  bool delivered = true;
  for (bool over = false; !over;) {
    const std::optional<std::string> bytes = readBytes();
    if (!bytes) {
      over = true;
      send(reader_.endSequence());
    } else if (bytes->empty()) {
      send(reader_.endSequence());
    } else {
      const std::size_t end = bytes->find('q');
      over = end != std::string::npos;
      send(reader_.read(std::string_view(*bytes).substr(0, end)));
    }
    // a script must not outrun its listeners
    if (over || !terminal.isTerminal()) delivered = publisher_.waitForDelivery(options_.timeout) && delivered;
  }
  return delivered ? kDone : fail("not all keys were received on " + options_.topic);
}

/// The keys of a script need a listener; with a terminal, the user may start the world later.
bool Keyboard::findListener(bool isTerminal) {
  if (publisher_.waitForSubscribers(options_.timeout)) return true;
  if (isTerminal) {
    say("no subscriber on " + options_.topic + " yet");
    return true;
  }
  fail("no subscriber on " + options_.topic, nearestTopic(options_.topic, topicsAround(transport_)));
  return false;
}

/// Waits for input.
/// @return The bytes; empty if a sequence was cut short; nothing at the end.
std::optional<std::string> Keyboard::readBytes() {
  std::array<pollfd, 2> watched{{{STDIN_FILENO, POLLIN, 0}, {stop_, POLLIN, 0}}};
  while (true) {
    const int count = poll(watched.data(), watched.size(), reader_.isWaiting() ? kSequenceMs : -1);
    if (count == 0) return "";
    if (count < 0 && errno != EINTR) return std::nullopt;
    if (count < 0) continue;
    if (watched[1].revents != 0) return std::nullopt;
    char bytes[256];
    const ssize_t size = read(STDIN_FILENO, bytes, sizeof bytes);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return std::nullopt;
    return std::string(bytes, static_cast<std::size_t>(size));
  }
}

void Keyboard::send(const std::vector<Key>& keys) {
  for (const Key& key : keys) {
    publisher_.publish(*msgs::int32Message(key.code));
    if (options_.json) {
      const nlohmann::ordered_json json = {{"key", key.name}, {"code", key.code}};
      print(json.dump() + "\n");
    } else {
      say(key.name + " (" + std::to_string(key.code) + ")");
    }
  }
}

}  // namespace

void addKeyCommand(CLI::App& program, Work& work) {
  const auto options = std::make_shared<KeyOptions>();
  CLI::App* command = program.add_subcommand("key", "Use the terminal as a keyboard: publish key presses");
  command
      ->add_option_function<std::string>(
          "-t,--topic", [options](const std::string& text) { options->topic = topicOption(text); },
          "The topic, of ignition.msgs.Int32 (/keyboard/keypress)")
      ->type_name("TOPIC");
  command
      ->add_option_function<std::string>(
          "--timeout",
          [options](const std::string& text) {
            options->timeout = std::chrono::milliseconds(wholeNumber("--timeout", text, 0, kLongestMs));
          },
          "Wait up to MS milliseconds (1000) for a subscriber, and for the last keys to arrive")
      ->type_name("MS");
  command
      ->add_flag("--json", options->json, "Report each key that is sent as a line of JSON on stdout, instead of text")
      ->disable_flag_override();
  addNetworkOption(*command);
  addSecureOption(*command);
  command->footer(
      "Sends the codes of Fortress's key publisher (Qt's): arrows, letters, digits, space, Enter, Tab, Backspace,\n"
      "Escape. q, Ctrl-C or the end of the input quits. Input from a pipe is read as keys, too.\n"
      "Examples:\n"
      "  pongsim key\n"
      "  printf 'w\\033[D ' | pongsim key");
  command->callback([options, &work] {
    work = [options] { return Keyboard(*options).run(); };
    setLogLevel(LogLevel::kError);
  });
}

}  // namespace pongsim::cli
