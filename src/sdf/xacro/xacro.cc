#include "sdf/xacro/xacro.hh"

#include <sys/wait.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <vector>

#include "base/child_process.hh"
#include "base/own_program.hh"
#include "base/text.hh"

namespace pongsim::sdf {

namespace fs = std::filesystem;

namespace {

constexpr const char* kPython = "python3";
// Of pongsim-xacro.
constexpr int kRefused = 3, kNoXacro = 4;

std::vector<std::string> partsOf(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find(separator));
    if (!part.empty()) parts.emplace_back(part);
    text.remove_prefix(std::min(part.size() + 1, text.size()));
  }
  return parts;
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// @return The program in PATH; empty if there is none.
fs::path programInPath(const std::string& name) {
  std::error_code ignored;
  for (const std::string& folder : partsOf(variable("PATH"), ':')) {
    if (fs::is_regular_file(fs::path(folder) / name, ignored)) return fs::path(folder) / name;
  }
  return {};
}

/// @return The interpreter in the first line of the program `xacro`, whose packages include xacro, else Python.
fs::path pythonOfXacro() {
  std::string line;
  if (const fs::path xacro = programInPath("xacro"); !xacro.empty()) {
    std::ifstream stream(xacro);
    std::getline(stream, line);
  }
  constexpr std::string_view kMark = "#!";
  if (line.starts_with(kMark)) {
    const fs::path interpreter = line.substr(kMark.size(), line.find(' ') - kMark.size());
    if (interpreter.is_absolute() && interpreter.filename().string().starts_with("python")) return interpreter;
  }
  return programInPath(kPython);
}

/// Reads "FILE<tab>LINE<tab>MESSAGE".
void report(const std::string& answer, const std::shared_ptr<const std::string>& name, Diagnostics& diagnostics) {
  const std::size_t file = answer.find('\t');
  const std::size_t line = file == std::string::npos ? file : answer.find('\t', file + 1);
  if (line == std::string::npos) return diagnostics.error({name}, "xacro ended without a result");
  SourcePosition position{std::make_shared<const std::string>(answer.substr(0, file))};
  std::from_chars(answer.data() + file + 1, answer.data() + line, position.line);
  std::string message = answer.substr(line + 1);
  while (message.ends_with('\n')) message.pop_back();
  diagnostics.error(std::move(position), "xacro: " + message);
}

}  // namespace

bool isXacro(const fs::path& file, std::string_view text) {
  return file.extension() == ".xacro" || file.stem().extension() == ".xacro" || text.find("<xacro:") != std::string_view::npos;
}

std::optional<ExpandedText> readExpandedText(const fs::path& file, const std::shared_ptr<const std::string>& name,
                                         NamedBy by, bool mayExpand, Diagnostics& diagnostics) {
  std::optional<std::string> text = readFileText(file, name, by, diagnostics);
  if (!text) return std::nullopt;
  std::error_code ignored;
  if (!isXacro(file, *text) || !fs::is_regular_file(file, ignored)) return ExpandedText{std::move(*text), name};
  if (!mayExpand) {
    diagnostics.error({name}, "is a xacro file of a model from outside, which is not expanded",
                      "expand it before: xacro FILE > FILE.urdf");
    return std::nullopt;
  }
  text = expandXacro(file, name, diagnostics);
  if (!text) return std::nullopt;
  return ExpandedText{std::move(*text), std::make_shared<const std::string>(*name + " (expanded)")};
}

std::optional<std::string> expandXacro(const fs::path& file, const std::shared_ptr<const std::string>& name,
                                       Diagnostics& diagnostics) {
  const auto fail = [&](std::string message, std::string hint = {}) {
    diagnostics.error({name}, std::move(message), std::move(hint));
    return std::nullopt;
  };
  const char* const advice = "install it: apt-get install ros-DISTRO-xacro, or pip install xacro";
  const fs::path program = base::ownProgram("pongsim-xacro"), python = pythonOfXacro();
  if (program.empty()) return fail("can't be expanded: pongsim-xacro is not installed", "install pongsim completely");
  if (python.empty()) return fail("is a xacro file, and there is no Python to expand it", advice);
  std::vector<std::string> words{program.string(), file.string()};
  for (std::string& argument : partsOf(variable("PONGSIM_XACRO_ARGUMENTS"), '\n')) words.push_back(std::move(argument));
  const Outcome<base::ChildResult> done = base::runChild(python, words);
  if (!done) return fail(done.error);
  const int code = WIFEXITED(done.value->status) ? WEXITSTATUS(done.value->status) : -1;
  if (code == 0) return done.value->output;
  if (code == kNoXacro) return fail("is a xacro file, and xacro is not installed", advice);
  if (code != kRefused) return fail("xacro was interrupted");
  report(done.value->output, name, diagnostics);
  return std::nullopt;
}

}  // namespace pongsim::sdf
