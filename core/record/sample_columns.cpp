// SPDX-License-Identifier: Apache-2.0
#include "record/sample_columns.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace syncline {
namespace {

struct Row {
  Signal column;
  PutColumn put;
};

template <auto Field>
constexpr Row whole(Signal column) {
  return {column, [](std::span<CycleSample> samples, const ColumnCells& cells) {
            using Type = std::remove_reference_t<decltype(samples.front().*Field)>;
            const auto& values = cells.integers;
            if (cells.there.empty()) {
              for (std::size_t i = 0; i < values.size(); ++i) samples[i].*Field = static_cast<Type>(values[i]);
              return;
            }
            for (std::size_t i = 0; i < values.size(); ++i) {
              if (cells.there[i] != 0) samples[i].*Field = static_cast<Type>(values[i]);
            }
          }};
}
template <auto Field>
constexpr Row real(Signal column) {
  return {column, [](std::span<CycleSample> samples, const ColumnCells& cells) {
            for (std::size_t i = 0; i < cells.floats.size(); ++i) {
              if (!std::isnan(cells.floats[i])) samples[i].*Field = cells.floats[i];
            }
          }};
}
template <auto Field>
constexpr Row state(Signal column) {
  return {column, [](std::span<CycleSample> samples, const ColumnCells& cells) {
            for (std::size_t i = 0; i < cells.integers.size(); ++i) {
              if (!cells.there.empty() && cells.there[i] == 0) continue;
              const auto value = cells.integers[i];
              const bool known = value >= 0 && value < kSyncStates;
              samples[i].*Field = known ? static_cast<SyncState>(value) : SyncState::kUnknown;
            }
          }};
}

constexpr Row stamped_by() {
  return {Signal::kStampedBy, [](std::span<CycleSample> samples, const ColumnCells& cells) {
            for (std::size_t i = 0; i < cells.integers.size(); ++i) {
              if (!cells.there.empty() && cells.there[i] == 0) continue;
              const auto value = cells.integers[i];
              const bool known = value >= 0 && value < kStampSources;
              samples[i].stamped_by = known ? static_cast<StampSource>(value) : StampSource::kUntold;
            }
          }};
}

constexpr std::array kSampleColumns{
    whole<&CycleSample::cycle>(Signal::kCycle),
    whole<&CycleSample::send_time>(Signal::kSendTime),
    whole<&CycleSample::flags>(Signal::kFlags),
    whole<&CycleSample::wake_lateness_ns>(Signal::kLateness),
    whole<&CycleSample::round_trip_ns>(Signal::kRoundTrip),
    whole<&CycleSample::reference_time>(Signal::kReferenceTime),
    whole<&CycleSample::dcm_error_ns>(Signal::kDcmError),
    whole<&CycleSample::dcm_error_filtered_ns>(Signal::kDcmErrorFiltered),
    real<&CycleSample::drift_ppm>(Signal::kDrift),
    whole<&CycleSample::dcm_adjust_ns>(Signal::kDcmAdjust),
    real<&CycleSample::dcm_output_sum_ns>(Signal::kDcmOutputSum),
    whole<&CycleSample::dcm_output_total_ns>(Signal::kDcmOutputTotal),
    whole<&CycleSample::dcm_error_code>(Signal::kDcmErrorCode),
    whole<&CycleSample::deviation_ns>(Signal::kDeviation),
    whole<&CycleSample::deviation_ored_ns>(Signal::kDeviationOred),
    whole<&CycleSample::slave_position>(Signal::kSlave),
    whole<&CycleSample::slave_deviation_ns>(Signal::kSlaveReading),
    whole<&CycleSample::sm2_position>(Signal::kSm2Slave),
    whole<&CycleSample::slave_sm2_missed>(Signal::kSm2Reading),
    whole<&CycleSample::slave_sm2_integrator>(Signal::kSm2IntegratorReading),
    whole<&CycleSample::wkc_expected>(Signal::kWkcExpected),
    whole<&CycleSample::wkc_received>(Signal::kWkcReceived),
    whole<&CycleSample::frames_lost>(Signal::kFramesLost),
    whole<&CycleSample::late_by_ns>(Signal::kFrameLateBy),
    whole<&CycleSample::skipped_cycles>(Signal::kSkippedCycles),
    state<&CycleSample::slaves_sync>(Signal::kSlavesSync),
    state<&CycleSample::master_sync>(Signal::kMasterSync),
    whole<&CycleSample::master_state>(Signal::kMasterState),
    whole<&CycleSample::sync_base>(Signal::kSyncBase),
    whole<&CycleSample::watch_list>(Signal::kWatchList),
    whole<&CycleSample::stamp_doubt_ns>(Signal::kStampDoubt),
    stamped_by(),
    whole<&CycleSample::external_error_ns>(Signal::kExternalError),
};

constexpr auto kColumns = [] {
  std::array<Signal, kSampleColumns.size()> columns{};
  for (std::size_t i = 0; i < kSampleColumns.size(); ++i) columns[i] = kSampleColumns[i].column;
  return columns;
}();

}  // namespace

std::span<const Signal> sample_columns() { return kColumns; }

PutColumn column_writer(std::int64_t signal) {
  for (const auto& row : kSampleColumns) {
    if (static_cast<std::int64_t>(row.column) == signal) return row.put;
  }
  return nullptr;
}

}  // namespace syncline
