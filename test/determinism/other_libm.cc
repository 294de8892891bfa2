// Elementary functions of "another C library", to be loaded before libm (LD_PRELOAD): each inexact result is off by one
// unit in the last place, as a library with other rounding might return. Results that stay the same with it do not
// depend on libm. With WHO_CALLS_LIBM it prints at the end, on standard error, which library called which function.

#include <dlfcn.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <mutex>

namespace {

constexpr int kMostCalls = 512;

/// Number of calls of each function by each library.
struct Calls {
  const char* library;
  const char* function;
  unsigned long count;
};
Calls calls[kMostCalls];
int callCount = 0;

void note(const char* function, void* caller) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  Dl_info info{};
  const char* library = dladdr(caller, &info) != 0 ? info.dli_fname : "?";
  for (int i = 0; i < callCount; ++i) {
    if (calls[i].library == library && calls[i].function == function) {
      ++calls[i].count;
      return;
    }
  }
  if (callCount < kMostCalls) calls[callCount++] = {library, function, 1};
}

const bool kNotes = std::getenv("WHO_CALLS_LIBM") != nullptr;

struct Report {
  ~Report() {
    for (int i = 0; i < callCount; ++i) {
      std::fprintf(stderr, "libm: %s %s %lu\n", calls[i].library, calls[i].function, calls[i].count);
    }
  }
} report;

/// @return The next larger or smaller number, depending on the bits of `number`.
template <class Number>
Number adjacent(Number number) {
  constexpr Number kInfinity = std::numeric_limits<Number>::infinity();
  if (!std::isfinite(number) || number == 0 || number == 1 || number == -1) return number;
  std::uint64_t bits = 0;
  if constexpr (sizeof number == sizeof bits) {
    bits = std::bit_cast<std::uint64_t>(number);
  } else {
    bits = std::bit_cast<std::uint32_t>(number);
  }
  const bool isUp = (bits * 0x9e3779b97f4a7c15U >> 63U) != 0;
  // results of sine and cosine stay within -1 to 1
  if (std::abs(number) < 1 && std::abs(number) > Number(0.999999)) return number;
  return std::nextafter(number, isUp ? kInfinity : -kInfinity);
}

}  // namespace

#define OTHER_1(name, Number)                                                               \
  extern "C" __attribute__((visibility("default"))) Number name(Number x) {                 \
    static const auto real = reinterpret_cast<Number (*)(Number)>(dlsym(RTLD_NEXT, #name)); \
    if (kNotes) note(#name, __builtin_return_address(0));                                   \
    return adjacent(real(x));                                                               \
  }
#define OTHER_2(name, Number)                                                                       \
  extern "C" __attribute__((visibility("default"))) Number name(Number x, Number y) {               \
    static const auto real = reinterpret_cast<Number (*)(Number, Number)>(dlsym(RTLD_NEXT, #name)); \
    if (kNotes) note(#name, __builtin_return_address(0));                                           \
    return adjacent(real(x, y));                                                                    \
  }
#define OTHER_SINCOS(name, Number)                                                                          \
  extern "C" __attribute__((visibility("default"))) void name(Number x, Number* sine, Number* cosine) {     \
    static const auto real = reinterpret_cast<void (*)(Number, Number*, Number*)>(dlsym(RTLD_NEXT, #name)); \
    if (kNotes) note(#name, __builtin_return_address(0));                                                   \
    real(x, sine, cosine);                                                                                  \
    *sine = adjacent(*sine);                                                                                \
    *cosine = adjacent(*cosine);                                                                            \
  }
#define OTHER_BOTH_1(name) OTHER_1(name, double) OTHER_1(name##f, float)
#define OTHER_BOTH_2(name) OTHER_2(name, double) OTHER_2(name##f, float)

OTHER_BOTH_1(sin)
OTHER_BOTH_1(cos)
OTHER_BOTH_1(tan)
OTHER_BOTH_1(asin)
OTHER_BOTH_1(acos)
OTHER_BOTH_1(atan)
OTHER_BOTH_1(sinh)
OTHER_BOTH_1(cosh)
OTHER_BOTH_1(tanh)
OTHER_BOTH_1(exp)
OTHER_BOTH_1(exp2)
OTHER_BOTH_1(expm1)
OTHER_BOTH_1(log)
OTHER_BOTH_1(log2)
OTHER_BOTH_1(log10)
OTHER_BOTH_1(log1p)
OTHER_BOTH_1(cbrt)
OTHER_BOTH_1(erf)
OTHER_BOTH_2(atan2)
OTHER_BOTH_2(pow)
OTHER_BOTH_2(hypot)
OTHER_SINCOS(sincos, double)
OTHER_SINCOS(sincosf, float)
