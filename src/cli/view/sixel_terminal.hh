#pragma once

#include <chrono>

namespace pongsim::cli {

/// Asks a terminal what it can ("primary device attributes", CSI c), and waits for its answer.
/// @param input, output Where the answer comes from and where the question goes: terminals, or there is no question.
/// @return Whether it says that it knows sixels; not where it says nothing in time.
bool knowsSixels(int input, int output, std::chrono::milliseconds patience);

}  // namespace pongsim::cli
