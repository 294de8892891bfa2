#include "cli/options/secure_option.hh"

#include <CLI/App.hpp>
#include <string>

#include "pongsim/program/keystore.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

void addSecureOption(CLI::App& command) {
  const auto secure = [](const std::string& place) {
    if (place.empty()) throw UsageError("option '--secure' takes a keystore, or KEYSTORE/NAME, not ''");
    // a mistake in it is an error even if the command ends up communicating with nobody
    readIdentity(identityFolder(place));
    secureBy(place);
  };
  command
      .add_option_function<std::string>("--secure", secure,
                                        "Encrypt everything, and communicate only with identities of this keystore,\n"
                                        "as one of them; 'pongsim security' creates keystores")
      ->type_name("KEYSTORE[/NAME]");
}

}  // namespace pongsim::cli
