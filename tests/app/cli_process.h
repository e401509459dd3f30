// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/types.h"

namespace syncline::test {

/// The host's time as samples and frames have it: nanoseconds since 2000.
inline Nanoseconds host_time() {
  const auto since_1970 = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since_1970).count() - kDcEpochUnixSeconds * kSecond;
}

/// synclinectl as a program of its own, from the folder of the tests' program; killed at the end if it still runs.
class CliProcess {
 public:
  /// `out`: file that takes the standard output; "": the test reads it.
  explicit CliProcess(const std::vector<std::string>& arguments, const std::string& out = "") {
    const auto program = (std::filesystem::read_symlink("/proc/self/exe").parent_path() / "synclinectl").string();
    std::vector<std::string> all{program};
    all.insert(all.end(), arguments.begin(), arguments.end());
    std::vector<char*> words;
    for (auto& word : all) words.push_back(word.data());
    words.push_back(nullptr);
    std::array<int, 2> out_pipe{}, err_pipe{};
    if (::pipe2(out_pipe.data(), O_CLOEXEC) != 0 || ::pipe2(err_pipe.data(), O_CLOEXEC) != 0) std::abort();
    child_ = ::fork();
    if (child_ == 0) {
      const int to = out.empty() ? out_pipe[1] : ::open(out.c_str(), O_WRONLY | O_CLOEXEC);
      ::dup2(to, STDOUT_FILENO);
      ::dup2(err_pipe[1], STDERR_FILENO);
      ::execv(words[0], words.data());
      ::_exit(127);
    }
    ::close(out_pipe[1]);
    ::close(err_pipe[1]);
    out_ = out_pipe[0];
    err_ = err_pipe[0];
  }
  ~CliProcess() {
    if (child_ > 0) {
      ::kill(child_, SIGKILL);
      ::waitpid(child_, nullptr, 0);
    }
    close_out();
    close_err();
  }
  CliProcess(const CliProcess&) = delete;
  CliProcess& operator=(const CliProcess&) = delete;

  void signal(int number) const { ::kill(child_, number); }
  /// 'T' while it is stopped, see proc(5).
  [[nodiscard]] char state() const {
    const auto text = proc_file("stat");
    const auto end = text.rfind(") ");  // of the program's name
    return end == std::string::npos ? '?' : text[end + 2];
  }
  /// Whether it has a handler of its own for the signal, or ignores it.
  [[nodiscard]] bool catches(int number) const { return in_mask("SigCgt:", number); }
  [[nodiscard]] bool ignores(int number) const { return in_mask("SigIgn:", number); }
  /// Exit code, or 128 and the signal's number. Reads what the program writes until then.
  int wait() {
    err_text_ += read_all(err_);
    out_text_ += read_all(out_);
    int status = 0;
    ::waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  /// Until the program has written these words to its error stream.
  bool wait_for_err(const std::string& words) {
    while (err_text_.find(words) == std::string::npos) {
      if (!read_some(err_, err_text_)) return false;
    }
    return true;
  }
  bool wait_for_out(const std::string& words) {
    while (out_text_.find(words) == std::string::npos) {
      if (!read_some(out_, out_text_)) return false;
    }
    return true;
  }
  void close_out() { close(out_); }
  void close_err() { close(err_); }
  [[nodiscard]] const std::string& out() const { return out_text_; }
  [[nodiscard]] const std::string& err() const { return err_text_; }

 private:
  [[nodiscard]] std::string proc_file(const std::string& name) const {
    std::ifstream in("/proc/" + std::to_string(child_) + "/" + name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] bool in_mask(const std::string& field, int number) const {
    const auto text = proc_file("status");
    const auto at = text.find(field);
    if (at == std::string::npos) return false;
    return (std::stoull(text.substr(at + field.size()), nullptr, 16) >> (number - 1) & 1U) != 0;
  }
  static bool read_some(int descriptor, std::string& text) {
    std::array<char, 4096> buffer{};
    const auto count = descriptor < 0 ? 0 : ::read(descriptor, buffer.data(), buffer.size());
    if (count <= 0) return false;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
  }
  static std::string read_all(int descriptor) {
    std::string text;
    while (read_some(descriptor, text)) {
    }
    return text;
  }
  static void close(int& descriptor) {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
  }

  pid_t child_ = -1;
  int out_ = -1, err_ = -1;
  std::string out_text_, err_text_;
};

}  // namespace syncline::test
