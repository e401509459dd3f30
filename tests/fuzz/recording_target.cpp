// SPDX-License-Identifier: Apache-2.0
#include "fuzz/recording_target.h"

#include <array>
#include <filesystem>
#include <iterator>

#include "fuzz/sandbox.h"
#include "record/first_columns.h"
#include "record/recorder.h"
#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "record/typed_values.h"
#include "tests/core/record/made_samples.h"

namespace syncline::fuzz {

void run_recording(std::span<const std::uint8_t> bytes) {
  static const Sandbox sandbox;
  sandbox.clear();
  sandbox.put("run.slrec", text_of(bytes));
  auto reader = RecordingReader::open(sandbox.file("run.slrec"));
  if (!reader) return promise(!reader.error().file.empty());
  const auto whole = reader->verify();
  const auto info = reader->info();
  std::uint64_t cycles = 0;
  const auto read = reader->samples([&cycles](std::span<const CycleSample> samples) {
    cycles += samples.size();
    return true;
  });
  (void)reader->overview(Signal::kDcmError);
  (void)reader->points(Signal::kSm2Missed, 2);
  if (info) {
    constexpr std::array kDrawn{Signal::kDeviation, Signal::kDcmError};
    const auto span = static_cast<std::uint64_t>(info->end) - static_cast<std::uint64_t>(info->begin);
    const auto width = static_cast<Nanoseconds>(span / 100 + 1);
    const auto drawn = first_columns(*reader, kDrawn, info->begin, info->end, width);
    if (whole) promise(drawn.has_value());
  }
  if (info) {
    NetworkConfig config;
    config.slaves.resize(info->about.slaves.size());
    const auto run = replay_run(*reader, config, {.cycle_capacity = 1});
    if (whole && run) promise(run->info.cycles == cycles);
    // What takes the place of another run shows something, unless nothing was recorded.
    if (run) promise(run->info.cycles == 0 || !run->record->samples().empty());
  }
  if (whole) promise(info && read && cycles == info->cycles);
}

std::vector<Bytes> recordings() {
  const Sandbox sandbox;
  RecordingAbout about;
  about.slaves.resize(3);
  {
    auto recorder = Recorder::start(sandbox.file("run.slrec"), about, {.keep_free_bytes = 0}, {});
    if (!recorder) return {};
    test::MadeSamples made(1);
    for (int i = 0; i < 20; ++i) (*recorder)->add(made.next(100));
    (*recorder)->add(RecordedEvent{1, 2, "frames_lost", "one", encode_event(events::FramesLost{1})});
    (*recorder)->tell(recorded(std::vector<Finding>{Finding{all_finding_words().front().code}}));
  }
  const auto whole = bytes_of_text(sandbox.text("run.slrec"));
  // And cut off where cycles are left.
  return {whole, Bytes(whole.begin(), whole.begin() + std::ssize(whole) * 3 / 4)};
}

}  // namespace syncline::fuzz
