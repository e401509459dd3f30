// SPDX-License-Identifier: Apache-2.0
// soak_kills [KILLS [SEED]]: kills each writer of files so often (1,000) at a random moment. What lies there afterwards
// must be the old content or the new one, byte for byte, and the next one to write must leave nothing else behind. Exit
// code 1 when that is not so.
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "capture/pcapng_writer.h"
#include "channels/cycle_sample.h"
#include "compile/compile.h"
#include "eni/format/eni_file.h"
#include "eni/project/project_file.h"
#include "support/output_file.h"
#include "support/random.h"
#include "support/whole_file.h"
#include "tests/support/sample_devices.h"
#include "trace/csv.h"

namespace syncline::bench {
namespace {

namespace fs = std::filesystem;

/// Writes the `which`th content, 0 or 1.
struct Writer {
  const char* name;
  std::function<Status(const std::string& path, std::size_t which)> write;
};

Project project_of(std::size_t which) {
  auto project = sample::small_machine();
  project.name = which == 0 ? "old" : "new";
  const auto slaves = project.slaves;
  if (which == 1) project.slaves.insert(project.slaves.end(), slaves.begin(), slaves.end());  // another length
  return project;
}

Status write_csv(const std::string& path, std::size_t which) {
  auto file = OutputFile::create(path);
  if (!file) return tl::unexpected(file.error());
  auto status = file->write(sample_csv_header());
  std::vector<CycleSample> samples(100);
  for (std::size_t piece = 0; status && piece < 3 + 2 * which; ++piece) {
    for (auto& sample : samples) sample.cycle = piece + 1'000 * which;
    std::string text;
    append_sample_csv(text, samples);
    status = file->write(text);
    if (status) status = file->flush();
  }
  return status ? file->finish() : status;
}

Status write_capture(const std::string& path, std::size_t which) {
  auto file = PcapngWriter::create(path);
  if (!file) return tl::unexpected(file.error());
  const std::vector<std::uint8_t> frame(60 + 100 * which, static_cast<std::uint8_t>(which));
  Status status;
  for (Nanoseconds time = 0; status && time < 200; ++time)
    status = file->write(frame, time, PcapngWriter::Direction::kSent);
  return status ? file->finish() : status;
}

std::vector<Writer> writers() {
  static const std::array<Project, 2> projects{project_of(0), project_of(1)};
  static const auto config = compile(projects[0])->config;
  static const auto renamed = [] {
    auto other = projects[0];
    other.slaves.pop_back();
    return compile(other)->config;
  }();
  return {
      {"project", [](const std::string& path, std::size_t which) { return eni::save_project(projects[which], path); }},
      {"ENI export",
       [](const std::string& path, std::size_t which) { return eni::save_eni(which == 0 ? config : renamed, path); }},
      {"CSV of samples", write_csv},
      {"capture", write_capture}};
}

struct Count {
  int kept_old = 0, has_new = 0, torn = 0, left_over = 0;
};

class Killer {
 public:
  explicit Killer(std::uint64_t seed) : random_(seed) {
    std::string pattern = (fs::temp_directory_path() / "syncline-kills-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) std::abort();
    folder_ = pattern;
  }
  ~Killer() {
    std::error_code none;
    fs::remove_all(folder_, none);
  }
  Killer(const Killer&) = delete;
  Killer& operator=(const Killer&) = delete;

  Count run(const Writer& writer, int kills) {
    const auto path = (folder_ / "file").string();
    std::array<std::string, 2> contents;
    for (const std::size_t which : {1U, 0U}) {
      if (!writer.write(path, which)) std::abort();
      contents[which] = read_whole_file(path).value_or("");
    }
    Count count;
    for (int i = 0; i < kills; ++i) {
      kill_one(writer, path);
      const auto found = read_whole_file(path).value_or("");
      if (found == contents[0]) ++count.kept_old;
      if (found == contents[1]) ++count.has_new;
      if (found != contents[0] && found != contents[1]) ++count.torn;
      if (!writer.write(path, 0)) std::abort();
      if (std::distance(fs::directory_iterator(folder_), {}) > 1) ++count.left_over;
    }
    fs::remove(path);
    return count;
  }

 private:
  void kill_one(const Writer& writer, const std::string& path) {
    const pid_t child = ::fork();
    if (child == 0) {
      for (std::size_t which = 1;; which = 1 - which) {
        if (!writer.write(path, which)) ::_exit(1);
      }
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random_.next() % 6'000));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!WIFSIGNALED(status)) std::abort();
  }

  Random random_;
  fs::path folder_;
};

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  const int kills = argc > 1 ? std::atoi(argv[1]) : 1'000;
  syncline::bench::Killer killer(argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
  bool kept = kills > 0;
  for (const auto& writer : syncline::bench::writers()) {
    const auto count = killer.run(writer, kills);
    fmt::print("{:16} {:5} kills: {:5} old, {:5} new, {} torn, {} with something left over\n", writer.name, kills,
               count.kept_old, count.has_new, count.torn, count.left_over);
    kept = kept && count.torn == 0 && count.left_over == 0 && count.kept_old > 0 && count.has_new > 0;
  }
  return kept ? 0 : 1;
}
