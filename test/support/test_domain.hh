#pragma once

namespace pongsim::test {

/// @return A DDS domain that no other test process of this user uses, always the same one in this process. Sets the
/// environment variable PONGSIM_DOMAIN to it, for this process and those that it starts. The domain is free again when
/// all of them have ended.
/// @throws std::runtime_error if all domains are in use.
int testDomain();

}  // namespace pongsim::test
