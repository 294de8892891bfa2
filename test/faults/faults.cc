// A library to be loaded before all others (LD_PRELOAD), which lets one call to the operating system or for memory
// fail.
//   PONGSIM_FAULT=KIND:N     the Nth call of that kind fails, counted from 1; none where N is 0
//   PONGSIM_FAULT_COUNTS=F   at the end a line "KIND COUNT" for each kind is written there
//   PONGSIM_FAULT_STACK=1    says who asked for the memory that fails
//   PONGSIM_FAULT_DISK=N     after N bytes written to ordinary files the disk is full
//   PONGSIM_FAULT_CLOCK=S:N  from the Nth look at the wall clock on it is S seconds later, which may be negative
// Kinds: memory (operator new, mmap without a file), file (open, read, write, rename, fsync, mkdir on ordinary files
// and folders), thread (pthread_create), socket (socket, bind, setsockopt, sendto, sendmsg, recvfrom, recvmsg), edit
// (memory while a model is inserted or removed: pongsimFaultsEdit). Memory fails only where pongsim asks for it, itself
// or through the C++ library: what other libraries make of it is theirs.

#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <new>
#include <string_view>

namespace {

enum Kind { kMemory, kFile, kThread, kSocket, kEdit, kKinds };
constexpr std::array<const char*, kKinds> kNames = {"memory", "file", "thread", "socket", "edit"};

std::array<std::atomic<std::uint64_t>, kKinds> counts;
std::atomic<std::uint64_t> clockLooks, written;
Kind failing = kKinds;
std::uint64_t failingCall = 0, disk = UINT64_MAX, clockCall = 0;
std::int64_t clockJump = 0;
/// Only while `main` runs: C++ ends the process if a constructor of a static object fails.
bool isReady = false;
/// The same holds in libraries that are being opened.
thread_local int opening = 0;
thread_local bool isEditing = false;
int (*realMain)(int, char**, char**) = nullptr;

/// Writes a message without functions that could fail in turn.
void say(const char* what, const char* who) {
  std::array<char, 400> text{};
  const int length = std::snprintf(text.data(), text.size(), "faults: %s%s\n", what, who);
  syscall(SYS_write, STDERR_FILENO, text.data(), static_cast<std::size_t>(length));
}

bool isOurs(std::string_view library) { return library.find("pongsim") != std::string_view::npos; }
bool isBetween(std::string_view library) {
  return library.find("libstdc++") != std::string_view::npos || library.find("libfaults") != std::string_view::npos;
}

/// @return Whether pongsim allocates: the first caller in the stack outside this library and that of C++. Optionally
/// prints it.
bool isAskedByUs() {
  std::array<void*, 64> stack{};
  const int depth = backtrace(stack.data(), static_cast<int>(stack.size()));
  for (int i = 0; i < depth; ++i) {
    Dl_info info{};
    if (dladdr(stack[static_cast<std::size_t>(i)], &info) == 0 || info.dli_fname == nullptr) continue;
    if (isBetween(info.dli_fname)) continue;
    if (std::getenv("PONGSIM_FAULT_STACK") != nullptr) backtrace_symbols_fd(stack.data(), depth, STDERR_FILENO);
    say(isOurs(info.dli_fname) ? "a call fails of " : "left alone, a call of ", info.dli_fname);
    return isOurs(info.dli_fname);
  }
  return false;
}

/// @return Whether code at that address is pongsim's, or the C++ library's, which may act for it. Caches known pages.
bool mayBeOurs(const void* code) {
  static std::array<std::atomic<std::uintptr_t>, 65536> known;
  const std::uintptr_t page = reinterpret_cast<std::uintptr_t>(code) >> 12;
  std::atomic<std::uintptr_t>& place = known[page % known.size()];
  const std::uintptr_t found = place.load(std::memory_order_relaxed);
  if (found >> 1 == page) return (found & 1) != 0;
  Dl_info info{};
  const bool is =
      dladdr(code, &info) != 0 && info.dli_fname != nullptr && (isOurs(info.dli_fname) || isBetween(info.dli_fname));
  place.store(page << 1 | (is ? 1 : 0), std::memory_order_relaxed);
  return is;
}

/// @return Whether this call is to fail.
bool fails(Kind kind) {
  if (!isReady || opening > 0) return false;
  const std::uint64_t number = ++counts[kind];
  if (kind != failing || number != failingCall) return false;
  const int before = errno;
  const bool isOne = (kind != kMemory && kind != kEdit) || isAskedByUs();
  errno = before;
  return isOne;
}

template <typename Function>
Function* real(const char* name, Function*& known) {
  if (known == nullptr) known = reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
  return known;
}
#define PONGSIM_REAL(name)                        \
  static decltype(::name)* found##name = nullptr; \
  auto* const next = real(#name, found##name)

bool isOrdinary(int file) {
  struct stat about {};
  return fstat(file, &about) == 0 && (S_ISREG(about.st_mode) || S_ISDIR(about.st_mode));
}

/// System files are opened by other code and are not affected.
bool isPathOfInterest(const char* path) {
  return std::strncmp(path, "/proc/", 6) != 0 && std::strncmp(path, "/sys/", 5) != 0 &&
         std::strncmp(path, "/dev/", 5) != 0;
}

bool isFull(int file, std::size_t size) {
  return isReady && disk != UINT64_MAX && isOrdinary(file) && (written += size) > disk;
}

int refuse(int error) {
  errno = error;
  return -1;
}

void* allocate(std::size_t size, const void* asker) {
  const bool isOurs = isReady && mayBeOurs(asker);
  const bool failsInEdit = isOurs && isEditing && fails(kEdit);
  if (!isOurs || (!fails(kMemory) && !failsInEdit)) return std::malloc(size == 0 ? 1 : size);
  // operator new throws in this case
  if (const std::new_handler handler = std::get_new_handler()) handler();
  return nullptr;
}

__attribute__((constructor)) void begin() {
  void* warmUp[1];
  backtrace(warmUp, 1);
  if (const char* text = std::getenv("PONGSIM_FAULT")) {
    for (int kind = 0; kind < kKinds; ++kind) {
      const std::size_t length = std::strlen(kNames[static_cast<std::size_t>(kind)]);
      if (std::strncmp(text, kNames[static_cast<std::size_t>(kind)], length) != 0 || text[length] != ':') continue;
      failing = static_cast<Kind>(kind);
      failingCall = std::strtoull(text + length + 1, nullptr, 10);
    }
  }
  if (const char* text = std::getenv("PONGSIM_FAULT_DISK")) disk = std::strtoull(text, nullptr, 10);
  if (const char* text = std::getenv("PONGSIM_FAULT_CLOCK")) {
    char* rest = nullptr;
    clockJump = std::strtoll(text, &rest, 10);
    clockCall = *rest == ':' ? std::strtoull(rest + 1, nullptr, 10) : 1;
  }
}

int runMain(int count, char** texts, char** environment) {
  isReady = true;
  const int code = realMain(count, texts, environment);
  isReady = false;
  return code;
}

__attribute__((destructor)) void end() {
  const char* const path = std::getenv("PONGSIM_FAULT_COUNTS");
  if (path == nullptr) return;
  const int file = static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0600));
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    std::array<char, 64> line{};
    const int length = std::snprintf(line.data(), line.size(), "%s %llu\n", kNames[kind],
                                     static_cast<unsigned long long>(counts[kind].load()));
    syscall(SYS_write, file, line.data(), static_cast<std::size_t>(length));
  }
  syscall(SYS_close, file);
}

}  // namespace

/// Called by the system of world.sdf: whether its thread inserts or removes a model from now on.
extern "C" void pongsimFaultsEdit(bool is) { isEditing = is; }

// Memory. Allocations of the C library and of libraries in C are not affected.
void* operator new(std::size_t size) {
  void* const memory = allocate(size, __builtin_return_address(0));
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* operator new[](std::size_t size) {
  void* const memory = allocate(size, __builtin_return_address(0));
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return allocate(size, __builtin_return_address(0));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return allocate(size, __builtin_return_address(0));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

extern "C" {

void* mmap(void* address, std::size_t size, int protection, int flags, int file, off_t offset) {
  PONGSIM_REAL(mmap);
  if ((flags & MAP_ANONYMOUS) == 0 || !isReady || !mayBeOurs(__builtin_return_address(0)) || !fails(kMemory)) {
    return next(address, size, protection, flags, file, offset);
  }
  errno = ENOMEM;
  return MAP_FAILED;
}

int __libc_start_main(int (*main)(int, char**, char**), int count, char** texts, void (*init)(), void (*fini)(),
                      void (*loaderFini)(), void* stack) {
  realMain = main;
  auto* const next = reinterpret_cast<decltype(&__libc_start_main)>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return next(runMain, count, texts, init, fini, loaderFini, stack);
}
void* dlopen(const char* path, int flags) {
  PONGSIM_REAL(dlopen);
  ++opening;
  void* const library = next(path, flags);
  --opening;
  return library;
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  if (isPathOfInterest(path) && fails(kFile)) return refuse(EMFILE);
  return static_cast<int>(syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}
int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return open(path, flags, mode);
}
FILE* fopen(const char* path, const char* mode) {
  PONGSIM_REAL(fopen);
  if (isPathOfInterest(path) && fails(kFile)) {
    errno = EMFILE;
    return nullptr;
  }
  return next(path, mode);
}
FILE* fopen64(const char* path, const char* mode) { return fopen(path, mode); }
size_t fread(void* to, size_t size, size_t count, FILE* file) {
  PONGSIM_REAL(fread);
  if (isOrdinary(fileno(file)) && fails(kFile)) {
    errno = EIO;
    return 0;
  }
  return next(to, size, count, file);
}
ssize_t read(int file, void* to, size_t size) {
  if (isReady && isOrdinary(file) && fails(kFile)) return refuse(EIO);
  return syscall(SYS_read, file, to, size);
}
ssize_t write(int file, const void* from, size_t size) {
  if (isFull(file, size)) return refuse(ENOSPC);
  if (isReady && isOrdinary(file) && fails(kFile)) return refuse(ENOSPC);
  return syscall(SYS_write, file, from, size);
}
ssize_t pwrite(int file, const void* from, size_t size, off_t at) {
  if (isFull(file, size)) return refuse(ENOSPC);
  if (isReady && fails(kFile)) return refuse(ENOSPC);
  return syscall(SYS_pwrite64, file, from, size, at);
}
ssize_t pwrite64(int file, const void* from, size_t size, off64_t at) { return pwrite(file, from, size, at); }
int fsync(int file) { return fails(kFile) ? refuse(EIO) : static_cast<int>(syscall(SYS_fsync, file)); }
int fdatasync(int file) { return fails(kFile) ? refuse(EIO) : static_cast<int>(syscall(SYS_fdatasync, file)); }
int mkdir(const char* path, mode_t mode) {
  return fails(kFile) ? refuse(EACCES) : static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}
int rename(const char* from, const char* to) {
  return fails(kFile) ? refuse(EACCES) : static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*run)(void*), void* with) {
  PONGSIM_REAL(pthread_create);
  return fails(kThread) ? EAGAIN : next(thread, attributes, run, with);
}

int socket(int domain, int type, int protocol) {
  return fails(kSocket) ? refuse(EMFILE) : static_cast<int>(syscall(SYS_socket, domain, type, protocol));
}
int bind(int number, const sockaddr* address, socklen_t length) {
  return fails(kSocket) ? refuse(EADDRINUSE) : static_cast<int>(syscall(SYS_bind, number, address, length));
}
int setsockopt(int number, int level, int name, const void* value, socklen_t length) {
  return fails(kSocket) ? refuse(ENOBUFS)
                        : static_cast<int>(syscall(SYS_setsockopt, number, level, name, value, length));
}
ssize_t sendto(int number, const void* from, size_t size, int flags, const sockaddr* address, socklen_t length) {
  return fails(kSocket) ? refuse(ENOBUFS) : syscall(SYS_sendto, number, from, size, flags, address, length);
}
ssize_t sendmsg(int number, const msghdr* message, int flags) {
  return fails(kSocket) ? refuse(ENOBUFS) : syscall(SYS_sendmsg, number, message, flags);
}
ssize_t recvfrom(int number, void* to, size_t size, int flags, sockaddr* address, socklen_t* length) {
  return fails(kSocket) ? refuse(ENOMEM) : syscall(SYS_recvfrom, number, to, size, flags, address, length);
}
ssize_t recvmsg(int number, msghdr* message, int flags) {
  return fails(kSocket) ? refuse(ENOMEM) : syscall(SYS_recvmsg, number, message, flags);
}

int clock_gettime(clockid_t clock, timespec* time) {
  PONGSIM_REAL(clock_gettime);
  const int result = next(clock, time);
  if (clock == CLOCK_REALTIME && isReady && clockJump != 0 && ++clockLooks >= clockCall) time->tv_sec += clockJump;
  return result;
}

}  // extern "C"
