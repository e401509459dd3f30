// SPDX-License-Identifier: Apache-2.0
#include "fuzz/import_targets.h"

#include <algorithm>
#include <array>

#include "capture/import_capture.h"
#include "fuzz/sandbox.h"
#include "fuzz/text_targets.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "record/import_run.h"
#include "record/recording_reader.h"
#include "record/replay_run.h"
#include "support/byte_order.h"
#include "tests/core/record/made_samples.h"
#include "trace/csv.h"

namespace syncline::fuzz {
namespace {

constexpr const char* kTable = "run.csv";
constexpr const char* kCapture = "run.pcap";

/// What is drawn of an imported run has all of its cycles, in their order.
void promise_run(const ImportedRun& run) {
  promise(!run.samples.empty());
  promise(std::ranges::is_sorted(run.samples, {}, &CycleSample::cycle));
  for (const auto& sample : run.samples) promise(sample.slave_position < static_cast<int>(run.about.slaves.size()));
  promise(replayed(run).info.cycles == run.samples.size());
}

/// A cycle's frame as it leaves, or as it comes back.
Bytes cyclic_frame(std::uint8_t index, bool returned) {
  FrameBuilder builder;
  (void)builder.add_zeros(Command::kLrw, index, 0x1000, 8);
  (void)builder.add_zeros(Command::kFrmw, index, device_address(1001, reg::kSystemTime), 8);
  (void)builder.add_zeros(Command::kFprd, index, device_address(1002, reg::kSystemTimeDifference), 4);
  const auto sent = builder.finish();
  Bytes frame(sent.begin(), sent.end());
  if (!returned) return frame;
  frame[6] |= 0x02;  // as the first slave marks it
  FrameReader reader(frame);
  while (auto datagram = reader.next()) datagram->set_wkc(1);
  return frame;
}

}  // namespace

void run_table(std::span<const std::uint8_t> bytes) {
  const auto run = import_table(text_of(bytes), kTable);
  if (!run) return promise(!run.error().file.empty() || !run.error().subject.empty());
  promise_run(*run);
}

std::vector<Bytes> tables() {
  test::MadeSamples made(1);
  auto text = sample_csv_header();
  append_sample_csv(text, made.next(20));
  auto corpus = dcm_logs();
  corpus.push_back(bytes_of_text(text));
  return corpus;
}

void run_import(std::span<const std::uint8_t> bytes) {
  static const Sandbox sandbox;
  sandbox.put(kCapture, text_of(bytes));
  const auto run = import_capture(sandbox.file(kCapture));
  if (!run) return promise(!run.error().file.empty() || !run.error().subject.empty());
  promise_run(*run);
}

std::vector<Bytes> captured_runs() {
  Bytes file;
  ByteWriter out(file);
  out.u32(0xA1B2C3D4).u16(2).u16(4).u32(0).u32(0).u32(65'535).u32(1);
  for (std::uint32_t cycle = 0; cycle < 8; ++cycle) {
    for (const bool returned : {false, true}) {
      const auto frame = cyclic_frame(static_cast<std::uint8_t>(cycle), returned);
      const auto length = static_cast<std::uint32_t>(frame.size());
      out.u32(1'700'000'000).u32(1000 * cycle + (returned ? 20 : 0)).u32(length).u32(length).bytes(frame);
    }
  }
  return {file};
}

}  // namespace syncline::fuzz
