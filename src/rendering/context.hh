#pragma once

namespace pongsim::rendering {

/// A way to draw by OpenGL, core profile 4.5, without a window.
class Context {
 public:
  using Function = void (*)();

  virtual ~Context() = default;

  /// Lets OpenGL's functions speak to it on this thread, until `release`. It is made at the first call.
  /// @throws std::runtime_error where it can't be.
  virtual void bind() = 0;
  virtual void release() = 0;

  /// @return A function of OpenGL's, while it is bound; null where there is none of that name.
  virtual Function function(const char* name) const = 0;
};

/// Binds a context for as long as it lives.
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
