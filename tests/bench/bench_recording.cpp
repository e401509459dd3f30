// SPDX-License-Identifier: Apache-2.0
// A recording of ten million cycles, opened as the window does, against reading its bytes.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "bench/long_recording.h"
#include "bench/ratio_report.h"
#include "findings/error_text.h"
#include "record/first_columns.h"
#include "record/replay_run.h"
#include "record/run_replay.h"
#include "tests/support/temporary_folder.h"

namespace syncline::bench {
namespace {

bool open_whole(const std::string& path) {
  auto reader = RecordingReader::open(path);
  if (!reader) return false;
  const auto run = replay_run(*reader, three_slaves());
  return run && run->info.cycles == kCycles && run->record->overview().deviation.now;
}

/// What the window shows of it first: the curves of the bus over the whole of it, as wide as a screen.
bool draw_first(const std::string& path) {
  constexpr std::array kDrawn{Signal::kDeviation, Signal::kDcmError, Signal::kDcmErrorFiltered};
  constexpr Nanoseconds kColumns = 1920;
  auto reader = RecordingReader::open(path);
  if (!reader) return false;
  const auto info = reader->info();
  if (!info) return false;
  const auto end = info->end + 1;
  const auto drawn = first_columns(*reader, kDrawn, info->begin, end, (end - info->begin) / kColumns);
  return drawn && std::ranges::all_of(*drawn, [](const auto& columns) { return columns[columns.size() / 2].valid; });
}

/// The longest that one of many moments, here and there, takes to be shown.
std::optional<double> worst_moment_ns(const std::string& path) {
  auto reader = RecordingReader::open(path);
  if (!reader) return std::nullopt;
  auto run = replay_run(*reader, three_slaves());
  if (!run) return std::nullopt;
  auto replay = RunReplay::open(std::move(*reader), *run);
  if (!replay) return std::nullopt;
  constexpr std::uint64_t kMoments = 200;
  double worst = 0;
  for (std::uint64_t i = 0; i < kMoments; ++i) {
    const auto part = static_cast<Nanoseconds>(i * 7919 % kMoments);
    const auto moment = replay->begin() + (replay->end() - replay->begin()) / static_cast<Nanoseconds>(kMoments) * part;
    const auto begin = processor_seconds();
    if (!replay->show(moment)) return std::nullopt;
    worst = std::max(worst, (processor_seconds() - begin) * 1e9);
  }
  replay->leave();
  return worst;
}

struct Taken {
  double ns = 0, mib = 0;  // of the processors; at its peak
  bool done = false;
};

double peak_mib() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / kMiB;
}

/// In a process of its own, whose peak of memory is that of the work.
Taken measure(const std::function<bool()>& work) {
  int told[2];
  Taken taken;
  if (::pipe(told) != 0) return taken;
  const pid_t child = ::fork();
  if (child == 0) {
    const auto before = peak_mib();
    const auto begin = all_processor_seconds();
    taken.done = work();
    taken.ns = (all_processor_seconds() - begin) * 1e9;
    taken.mib = peak_mib() - before;
    ::_exit(::write(told[1], &taken, sizeof taken) == sizeof taken ? 0 : 1);
  }
  ::close(told[1]);
  if (::read(told[0], &taken, sizeof taken) != sizeof taken) taken.done = false;
  ::close(told[0]);
  ::waitpid(child, nullptr, 0);
  return taken;
}

/// A gigabyte, as its user waits for it: who reads it from a disk waits for the disk, too.
void bench_gigabyte(RatioReport& report, double bytes_a_cycle) {
  constexpr double kGigabyte = 1e9, kTwoSeconds = 2e9;
  const test::TemporaryFolder folder;
  const auto path = folder.file("long.slrec");
  const auto cycles = static_cast<std::size_t>(1.01 * kGigabyte / bytes_a_cycle);
  if (const auto status = write_recording(path, cycles); !status)
    return report.add_failure("write a gigabyte", describe(status.error()));
  const auto size = static_cast<double>(std::filesystem::file_size(path));
  if (size < kGigabyte) return report.add_failure("write a gigabyte", fmt::format("it has {:.0f} MiB", size / kMiB));
  const auto bytes = measure([&] {
    read_bytes(path);
    return true;
  });
  const auto drawn = measure([&] { return draw_first(path); });
  if (!bytes.done || !drawn.done) return report.add_failure("open a gigabyte", "it could not be read");
  report.add(fmt::format("first picture of {:.0f} MiB", size / kMiB), drawn.ns, "two seconds", kTwoSeconds, 1);
  report.add("the same", drawn.ns, "reading its bytes", bytes.ns, 0);
}

void bench_open(RatioReport& report) {
  const test::TemporaryFolder folder;
  const auto path = folder.file("run.slrec");
  if (const auto status = write_recording(path); !status) return report.add_failure("write", describe(status.error()));
  const auto mib = static_cast<double>(std::filesystem::file_size(path)) / kMiB;
  const auto bytes = measure([&] {
    read_bytes(path);
    return true;
  });
  const auto drawn = measure([&] { return draw_first(path); });
  const auto opened = measure([&] { return open_whole(path); });
  if (!bytes.done || !drawn.done || !opened.done) return report.add_failure("open", "it could not be read");
  const auto baseline = fmt::format("reading its {:.0f} MiB", mib);
  report.add("first picture of 10 million cycles", drawn.ns, baseline, bytes.ns, 3);
  report.add("all of them", opened.ns, baseline, bytes.ns, 0);
  const auto moment = worst_moment_ns(path);
  if (!moment) return report.add_failure("a moment", "it could not be shown");
  report.add("any moment of it, the slowest", *moment, "a picture, 30 a second", 33e6, 1);
  report.add_count("memory of it, open", opened.mib, "MiB", mib, "MiB of the file", 3);
  std::filesystem::remove(path);
  bench_gigabyte(report, mib * kMiB / static_cast<double>(kCycles));
}

}  // namespace
}  // namespace syncline::bench

int main() {
  syncline::bench::RatioReport report;
  syncline::bench::bench_open(report);
  return report.finish("Recordings");
}
