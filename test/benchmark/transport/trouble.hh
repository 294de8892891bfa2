#pragma once

namespace pongsim::benchmark {

/// Measures the duration of publishing with subscribers that are slow, stopped or killed, and with a flood of other
/// messages. Prints the results.
void measureTroubles();

}  // namespace pongsim::benchmark
