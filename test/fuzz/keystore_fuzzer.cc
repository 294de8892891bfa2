// Any bytes as the permissions and the governance of a keystore, as they stand after their signature was checked.
// Whatever they are, the readers end, and say why where they refuse them.

#include <cstddef>
#include <cstdint>
#include <string>

#include "pongsim/program/keystore.hh"
#include "require.hh"
#include "trust/governance.hh"
#include "trust/permissions.hh"

namespace {

template <class Read>
void attempt(const Read& read) {
  try {
    read();
  } catch (const pongsim::KeystoreError& error) {
    pongsim::fuzz::require(*error.what() != '\0');
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace trust = pongsim::trust;
  const std::string text(reinterpret_cast<const char*>(data), size);
  attempt([&] {
    for (const auto& grant : trust::readPermissions("permissions.p7s", text)) {
      attempt([&] { trust::requireUsable("permissions.p7s", grant, 0); });
    }
  });
  attempt([&] { trust::requireDomain("governance.p7s", trust::readGovernance("governance.p7s", text), 0); });
  return 0;
}
