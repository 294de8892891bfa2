#pragma once

#include <memory>
#include <stdexcept>

namespace pongsim::rendering {

/// An OpenGL context, core profile 4.5, without a window.
class Context {
 public:
  using Function = void (*)();

  virtual ~Context() = default;

  /// Makes it current on this thread until `release`. The first call creates it.
  /// @throws std::runtime_error if it can't be created.
  virtual void bind() = 0;
  virtual void release() = 0;

  /// @return An OpenGL function, while bound; null if there is none with this name.
  virtual Function function(const char* name) const = 0;
};

/// There is no graphics card.
class NoCard : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What draws, and what draws instead once that can't; null: nothing.
struct Contexts {
  std::unique_ptr<Context> first;
  std::unique_ptr<Context> spare = nullptr;
};

/// Keeps a context bound for its own lifetime.
class Binding {
 public:
  explicit Binding(Context& context) : context_(context) { context_.bind(); }
  ~Binding() { context_.release(); }
  Binding(const Binding&) = delete;
  Binding& operator=(const Binding&) = delete;

 private:
  Context& context_;
};

}  // namespace pongsim::rendering
