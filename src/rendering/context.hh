#pragma once

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
