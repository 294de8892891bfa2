#pragma once

namespace pongsim::test {

/// @return A DDS domain that no other test process of this user has, the same one for this process's life. Sets the
/// environment variable PONGSIM_DOMAIN to it, for this process and those that it starts. The domain stays taken until
/// they have ended too.
/// @throws std::runtime_error where all are taken.
int testDomain();

}  // namespace pongsim::test
