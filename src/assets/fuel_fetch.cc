#include "assets/fuel_fetch.hh"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "base/child_process.hh"
#include "base/file_descriptor.hh"
#include "base/own_program.hh"
#include "pongsim/files/fuel_address.hh"
#include "pongsim/log.hh"

namespace pongsim::assets {

namespace fs = std::filesystem;

namespace {

/// @return The model or world that an address belongs to, in a form that is the same for all its files.
std::optional<std::string> resourceOf(const std::string& address) {
  const std::optional<FuelAddress> parsed = parseFuelAddress(address);
  if (!parsed) return std::nullopt;
  return parsed->url() + "/" + (parsed->version ? std::to_string(*parsed->version) : "tip");
}

/// Writes the text to a file that a process can then read as its input.
bool fill(const base::FileDescriptor& file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file.number(), text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::lseek(file.number(), 0, SEEK_SET) == 0;
}

/// @return The text before the next tab, which is removed with it.
std::string takeField(std::string_view& line) {
  const std::string_view field = line.substr(0, line.find('\t'));
  line.remove_prefix(std::min(field.size() + 1, line.size()));
  return std::string(field);
}

}  // namespace

FuelFetch::FuelFetch(Places places, fs::path program)
    : places_(std::move(places)), program_(program.empty() ? base::ownProgram("pongsim-fuel") : std::move(program)) {}

void FuelFetch::bring(const std::vector<std::string>& addresses) {
  std::vector<std::string> missing;
  for (const std::string& address : addresses) {
    const std::optional<std::string> resource = resourceOf(address);
    if (!resource || requested_.contains(*resource) || findInFuelCache(*parseFuelAddress(address), places_.fuelCache))
      continue;
    requested_.insert(*resource);
    missing.push_back(*resource);
  }
  if (!missing.empty() && !program_.empty() && !isFuelOffline()) run(missing);
}

void FuelFetch::run(const std::vector<std::string>& addresses) {
  const auto fail = [&](const std::string& why) {
    for (const std::string& address : addresses) failed_[address] = {why, {}};
  };
  std::string text;
  for (const std::string& address : addresses) text += address + "\n";
  const base::FileDescriptor input(::memfd_create("pongsim-fuel", MFD_CLOEXEC));
  if (input.number() < 0 || !fill(input, text)) return fail(std::strerror(errno));
  // progress is only shown to users who want log messages at all
  const std::string level = logLevel() < LogLevel::kWarning ? "1" : "3";
  const Outcome<base::ChildResult> done = base::runChild(program_, {"fetch", "-v", level}, input.number());
  if (!done) return fail(done.error);
  const auto& [answer, status] = *done.value;
  // one line for each finished address: "ok ADDRESS" or "failed ADDRESS TAB WHY TAB ADVICE"
  fail(WIFSIGNALED(status) ? "the download was interrupted" : "the download ended without a result");
  for (std::string_view rest = answer; !rest.empty();) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (line.starts_with("ok ")) failed_.erase(std::string(line.substr(3)));
    if (!line.starts_with("failed ")) continue;
    line.remove_prefix(7);
    const std::string address = takeField(line);
    const std::string why = takeField(line);
    failed_[address] = {why, takeField(line)};
  }
}

Problem FuelFetch::whyNot(const std::string& address) const {
  const std::string missing = "'" + address + "' is not in the local Fuel cache";
  if (isFuelOffline()) return {missing, "downloads are off: PONGSIM_OFFLINE or --offline is set"};
  if (program_.empty()) return {missing, "install pongsim-fuel to download it: apt-get install pongsim-fuel"};
  const std::optional<std::string> resource = resourceOf(address);
  const auto failed = resource ? failed_.find(*resource) : failed_.end();
  if (failed != failed_.end()) {
    return {"'" + address + "' can't be downloaded: " + failed->second.text, failed->second.hint};
  }
  return {missing, "there is no such model or file on the server"};
}

}  // namespace pongsim::assets
