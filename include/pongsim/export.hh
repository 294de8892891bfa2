#pragma once

/// Exports a symbol from libpongsim.so; all others are hidden.
#define PONGSIM_API __attribute__((visibility("default")))
