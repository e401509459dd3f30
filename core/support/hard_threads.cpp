// SPDX-License-Identifier: Apache-2.0
#include "support/hard_threads.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "support/paths_in.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kKernelThread = 0x00200000;  // PF_KTHREAD of the kernel's sched.h

// Fields of /proc/PID/stat behind the name, by proc(5), counted from "state" (3) as 0.
constexpr std::size_t kFlags = 9 - 3, kPriority = 40 - 3, kPolicy = 41 - 3;

std::string first_line(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line;
}

struct ThreadState {
  std::string name;
  std::uint64_t flags = 0;
  int priority = 0, policy = 0;
};

/// The name stands in parentheses and may have some itself.
std::optional<ThreadState> thread_state(const std::string& line) {
  const auto open = line.find('('), close = line.rfind(')');
  if (open == std::string::npos || close == std::string::npos || close < open) return std::nullopt;
  std::istringstream words(line.substr(close + 1));
  std::vector<std::string> fields;
  for (std::string word; words >> word;) fields.push_back(std::move(word));
  if (fields.size() <= kPolicy) return std::nullopt;
  const auto number = [&fields](std::size_t at, auto& out) {
    const auto& text = fields[at];
    return std::from_chars(text.data(), text.data() + text.size(), out).ec == std::errc();
  };
  ThreadState state{line.substr(open + 1, close - open - 1)};
  if (!number(kFlags, state.flags) || !number(kPriority, state.priority) || !number(kPolicy, state.policy))
    return std::nullopt;
  return state;
}

bool is_hard(const ThreadState& state, int priority) {
  if ((state.flags & kKernelThread) != 0) return true;
  constexpr int kDeadline = 6;  // SCHED_DEADLINE stands above all others
  const bool real_time = state.policy == SCHED_FIFO || state.policy == SCHED_RR;
  return state.policy == kDeadline || (real_time && state.priority >= priority);
}

void add_thread(const fs::path& folder, int priority, std::vector<ThreadRun>& out) {
  const auto state = thread_state(first_line(folder / "stat"));
  if (!state || !is_hard(*state, priority)) return;
  std::istringstream numbers(first_line(folder / "schedstat"));
  ThreadRun run;
  Nanoseconds waited = 0;
  if (!(numbers >> run.ran >> waited >> run.slices)) return;
  run.id = std::stoll(folder.filename().string());
  run.name = state->name;
  run.kernel = (state->flags & kKernelThread) != 0;
  out.push_back(std::move(run));
}

bool is_number(const fs::path& folder) {
  const auto name = folder.filename().string();
  return !name.empty() && name.size() < 18 && std::ranges::all_of(name, [](char c) { return c >= '0' && c <= '9'; });
}

/// Those folders below that are named by a number; none when it cannot be read.
std::vector<fs::path> numbered(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (auto& path : paths_in(folder, error)) {
    if (is_number(path)) found.push_back(std::move(path));
  }
  return found;
}

}  // namespace

std::vector<ThreadRun> hard_threads(int priority, const fs::path& proc) {
  std::vector<ThreadRun> found;
  const auto own = std::to_string(::getpid());
  for (const auto& process : numbered(proc)) {
    if (process.filename() == own) continue;
    for (const auto& thread : numbered(process / "task")) add_thread(thread, priority, found);
  }
  return found;
}

std::optional<ThreadRun> longest_at_a_time(std::span<const ThreadRun> before, std::span<const ThreadRun> after) {
  std::optional<ThreadRun> longest;
  for (auto run : after) {
    const auto same =
        std::ranges::find_if(before, [&run](const ThreadRun& old) { return old.id == run.id && old.name == run.name; });
    if (same != before.end()) {
      if (run.ran < same->ran || run.slices < same->slices) continue;  // another thread got its number
      run.ran -= same->ran;
      run.slices -= same->slices;
    }
    if (run.slices == 0) continue;
    const auto mean = [](const ThreadRun& of) { return of.ran / static_cast<Nanoseconds>(of.slices); };
    if (mean(run) > 0 && (!longest || mean(run) > mean(*longest))) longest = std::move(run);
  }
  return longest;
}

}  // namespace syncline
