// Arbitrary bytes as permissions and governance of a keystore, after their signature was checked. The readers must end,
// and give a reason if they refuse them.

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
