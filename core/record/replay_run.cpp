// SPDX-License-Identifier: Apache-2.0
#include "record/replay_run.h"

#include <fmt/format.h>

#include <utility>

namespace syncline {
namespace {

/// Counts and states, which no sample tells.
Status restore_held(RecordingReader& reader, RunRecord& record) {
  for (const auto& signal : signals()) {
    const bool of_slaves = signal.scope == SignalInfo::Scope::kSlave;
    if (signal.form != SignalInfo::Form::kHeld || (!of_slaves && signal.of_bus == nullptr)) continue;
    const auto count = of_slaves ? static_cast<int>(record.config().slaves.size()) : 1;
    for (int slave = 0; slave < count; ++slave) {
      const auto points = reader.points(signal.id, of_slaves ? slave : -1);
      if (!points) return tl::unexpected(points.error());
      record.restore(signal.id, static_cast<std::size_t>(slave), points->times, points->values);
    }
  }
  return {};
}

}  // namespace

Result<ReplayedRun> replay_run(RecordingReader& reader, NetworkConfig config, std::size_t cycle_capacity) {
  auto info = reader.info();
  if (!info) return tl::unexpected(info.error());
  if (info->about.slaves.size() != config.slaves.size()) {
    return fail(ErrorCode::kBadValue, "configuration",
                fmt::format("it has {} slaves, the recording has {}", config.slaves.size(), info->about.slaves.size()));
  }
  ReplayedRun run{std::make_unique<RunRecord>(std::move(config), cycle_capacity), std::move(*info)};
  auto status = reader.samples([&run](std::span<const CycleSample> samples) {
    run.record->add(samples);
    return true;
  });
  if (status) status = restore_held(reader, *run.record);
  if (!status) return tl::unexpected(status.error());
  return run;
}

}  // namespace syncline
