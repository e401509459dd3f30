// SPDX-License-Identifier: Apache-2.0
#include "record/import_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "findings/recording_words.h"
#include "findings/sentence.h"
#include "reasons/because.h"
#include "record/recording_schema.h"
#include "record/recording_writer.h"
#include "record/replay_run.h"
#include "sqlite/database_files.h"
#include "support/utf8.h"
#include "trace/dcm_log.h"
#include "trace/untold.h"

namespace syncline {
namespace {

/// Files hold any times: 0 where the later one is not later, or by more than can be told.
Nanoseconds distance_between(const CycleSample& earlier, const CycleSample& later) {
  Nanoseconds distance = 0;
  return __builtin_sub_overflow(later.send_time, earlier.send_time, &distance) || distance < 0 ? 0 : distance;
}

}  // namespace

Nanoseconds cycle_time_of(const std::vector<CycleSample>& samples) {
  std::vector<Nanoseconds> distances;
  distances.reserve(samples.size());
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto cycles = static_cast<Nanoseconds>(samples[i].cycle - samples[i - 1].cycle);
    if (const auto distance = distance_between(samples[i - 1], samples[i]); distance > 0 && cycles > 0)
      distances.push_back(distance / cycles);
  }
  if (distances.empty()) return 0;
  constexpr Nanoseconds kGrain = 500;  // of 62.5 us and its multiples
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::ranges::nth_element(distances, middle);
  // The mean of those that are no gaps: a jitter that comes again and again moves the middle one.
  const auto usual = *middle;
  double off = 0;  // from the usual one, and so within half of it
  std::size_t count = 0;
  for (const auto distance : distances) {
    if (distance < usual / 2 || distance - usual > usual / 2) continue;
    off += static_cast<double>(distance - usual);
    ++count;
  }
  const auto mean = usual + static_cast<Nanoseconds>(off / static_cast<double>(count));
  return std::max(mean / kGrain * kGrain + (mean % kGrain >= kGrain / 2 ? kGrain : 0), Nanoseconds{1});
}

void count_cycles(std::vector<CycleSample>& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].cycle = i;
  const auto cycle = cycle_time_of(samples);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto distance = distance_between(samples[i - 1], samples[i]);
    const auto steps =
        cycle > 0 ? std::max<Nanoseconds>(distance / cycle + (distance % cycle >= cycle / 2 ? 1 : 0), 1) : 1;
    samples[i].cycle = samples[i - 1].cycle + static_cast<std::uint64_t>(steps);
  }
}

namespace {

using Flag = CycleSample::Flag;

/// A log without a date begins a second after the epoch of distributed clocks: 0 is no time.
constexpr Nanoseconds kNoDate = kSecond;
constexpr Nanoseconds kFirstDate = 10LL * 365 * 24 * 3600 * kSecond;  // 2010: what is older is no date of a bus

/// Yes or no of a log as a verdict: before it came first, nobody knows more than that it has not come yet.
class Verdict {
 public:
  explicit Verdict(bool told) : told_(told) {}
  SyncState of(bool in_sync) {
    if (!told_) return SyncState::kUnknown;
    was_ = was_ || in_sync;
    if (in_sync) return SyncState::kInSync;
    return was_ ? SyncState::kOutOfSync : SyncState::kBusy;
  }

 private:
  bool told_, was_ = false;
};

/// What a column of the samples can hold.
template <class T>
T fitting(std::int64_t value) {
  constexpr auto kLeast = std::numeric_limits<T>::min(), kMost = std::numeric_limits<T>::max();
  return static_cast<T>(std::clamp<std::int64_t>(value, kLeast, kMost));
}

tl::unexpected<Error> no_cycles(const std::string& name, Reason why) {
  return fail(ErrorCode::kBadValue, name, std::move(why));
}

/// Of the last line of a file, which has no end.
Finding unended(int line, bool kept) {
  const auto number = fig::number<"line">(line);
  auto finding = kept ? make_finding<words::kRecording>("import-line-cut/kept", {}, number)
                      : make_finding<words::kRecording>("import-line-cut", {}, number);
  if (kept) finding.severity = Severity::kNote;
  return finding;
}

// ---- log of the master synchronisation -----------------------------------------------------------------------------

/// Of a century, in ns: what is beyond leaves no room to count with.
bool is_time(std::int64_t time) { return time >= 0 && time <= 100LL * 366 * 24 * 3600 * kSecond; }

/// At most by so much that it can be added to any date.
std::int64_t later_by(std::int64_t time, std::int64_t begin) {
  constexpr std::int64_t kMost = 900'000'000 * kSecond;
  std::int64_t distance = 0;
  if (__builtin_sub_overflow(time, begin, &distance)) return time < begin ? -kMost : kMost;
  return std::clamp(distance, -kMost, kMost);
}

/// By the host's clock where its column tells the cycles apart, else by the bus's.
Status put_times(const DcmLogTable& log, std::vector<CycleSample>& samples, const std::string& name) {
  const auto& rows = log.rows;
  const bool has_bus_time = log.has("BusTime [ns]") && rows.front().bus_time_ns > 0;
  const auto same_time = [](const DcmLogRow& a, const DcmLogRow& b) { return a.time_ms == b.time_ms; };
  const bool by_host = log.has("Time[ms]") && std::ranges::adjacent_find(rows, same_time) == rows.end();
  if (!by_host && !has_bus_time && rows.size() > 1)
    return no_cycles(name, because("its times do not tell the cycles apart"));
  const auto first = rows.front().bus_time_ns;
  const auto begin = has_bus_time && first > kFirstDate && is_time(first) ? first : kNoDate;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto since = by_host ? std::llround(std::clamp((rows[i].time_ms - rows.front().time_ms) * 1e6, 0.0, 9e17))
                               : later_by(rows[i].bus_time_ns, rows.front().bus_time_ns);
    samples[i].send_time = begin + since;
  }
  return {};
}

CycleSample sample_of(const DcmLogRow& row, const DcmLogTable& log) {
  CycleSample sample;
  sample.flags = kStateUntold | kLatenessUntold | kRoundTripUntold | kFramesUntold | kExpectedUntold;
  if (!log.has("CtlOutSum") || !log.has("CtlOutTot")) sample.flags |= kLearnedUntold;
  if (log.has("BusTime [ns]") && is_time(row.bus_time_ns)) sample.reference_time = row.bus_time_ns;
  if (log.has("CtlErr [ns]")) {
    sample.flags |= Flag::kReferenceValid | Flag::kDcmActive;
    sample.dcm_error_ns = fitting<std::int32_t>(-row.error_ns);
    const bool filtered = log.has("CtlErrFilt");
    sample.dcm_error_filtered_ns = filtered ? fitting<std::int32_t>(-row.error_filtered_ns) : sample.dcm_error_ns;
    sample.drift_ppm = -static_cast<float>(row.drift_ppm);
    sample.dcm_adjust_ns = fitting<std::int32_t>(row.adjust_ns);
    sample.dcm_output_sum_ns = static_cast<float>(row.output_sum);
    sample.dcm_output_total_ns = row.output_total;
    sample.dcm_error_code = row.error_code;
  }
  if (row.system_time_difference_ns) {
    // Of all that were read at once: an upper estimate of the largest.
    sample.flags |= Flag::kDeviationValid | Flag::kFollowersRead;
    sample.deviation_ored_ns = fitting<std::uint32_t>(std::llabs(*row.system_time_difference_ns));
    sample.deviation_ns = sample.deviation_ored_ns;
  }
  return sample;
}

Result<ImportedRun> import_dcm_log(std::string_view text, const std::string& name) {
  const auto log = read_dcm_table(text);
  if (!log) return tl::unexpected(log.error());
  if (log->rows.empty()) return no_cycles(name, because("it has no rows"));
  ImportedRun run;
  if (log->unended_line > 0) run.findings.push_back(unended(log->unended_line, !log->left_out));
  Verdict slaves(log->has("DCInSync")), master(log->has("DCMInSync"));
  run.samples.reserve(log->rows.size());
  for (const auto& row : log->rows) {
    auto& sample = run.samples.emplace_back(sample_of(row, *log));
    sample.slaves_sync = slaves.of(row.dc_in_sync);
    sample.master_sync = master.of(row.dcm_in_sync);
  }
  if (auto status = put_times(*log, run.samples, name); !status) return tl::unexpected(status.error());
  count_cycles(run.samples);
  run.about.program = "import of a log of the master synchronisation";
  if (!log->has("DCInSync") || !log->has("DCMInSync")) run.about.armed = run.samples.front().send_time;
  return run;
}

// ---- table of a run ------------------------------------------------------------------------------------------------

/// A cell that has a number, of a sample that began without any.
using PutCell = void (*)(CycleSample&, std::int64_t whole, double real);
struct TableColumn {
  Signal signal;
  PutCell put;
};

template <auto Field, std::uint16_t kSet = 0>
constexpr TableColumn cell(Signal signal) {
  return {signal, [](CycleSample& sample, std::int64_t whole, double) {
            using Type = std::remove_reference_t<decltype(sample.*Field)>;
            sample.*Field = fitting<Type>(whole);
            sample.flags = static_cast<std::uint16_t>(sample.flags | kSet);
          }};
}

constexpr std::array kTableColumns{
    cell<&CycleSample::send_time>(Signal::kSendTime),
    cell<&CycleSample::wake_lateness_ns>(Signal::kLateness),
    cell<&CycleSample::round_trip_ns>(Signal::kRoundTrip),
    cell<&CycleSample::reference_time, Flag::kReferenceValid>(Signal::kReferenceTime),
    cell<&CycleSample::dcm_error_ns, Flag::kReferenceValid | Flag::kDcmActive>(Signal::kDcmError),
    cell<&CycleSample::dcm_error_filtered_ns>(Signal::kDcmErrorFiltered),
    TableColumn{Signal::kDrift,
                [](CycleSample& sample, std::int64_t, double real) { sample.drift_ppm = static_cast<float>(real); }},
    cell<&CycleSample::dcm_adjust_ns, Flag::kDcmActive>(Signal::kDcmAdjust),
    cell<&CycleSample::deviation_ored_ns, Flag::kDeviationValid>(Signal::kDeviationOred),
    cell<&CycleSample::slave_position>(Signal::kSlave),
    cell<&CycleSample::slave_deviation_ns>(Signal::kSlaveReading),
    cell<&CycleSample::sm2_position>(Signal::kSm2Slave),
    cell<&CycleSample::slave_sm2_missed>(Signal::kSm2Reading),
    cell<&CycleSample::wkc_expected>(Signal::kWkcExpected),
    cell<&CycleSample::wkc_received>(Signal::kWkcReceived),
    TableColumn{Signal::kFrameLost,
                [](CycleSample& sample, std::int64_t whole, double) {
                  if (whole != 0) sample.flags |= Flag::kFrameLost;
                }},
    cell<&CycleSample::frames_lost>(Signal::kFramesLost),
    cell<&CycleSample::late_by_ns, Flag::kFrameLate>(Signal::kFrameLateBy),
    cell<&CycleSample::skipped_cycles>(Signal::kSkippedCycles),
    cell<&CycleSample::deviation_ns, Flag::kFollowersRead>(Signal::kDeviation),
    TableColumn{Signal::kSlaveFollows,
                [](CycleSample& sample, std::int64_t whole, double) {
                  if (whole != 0) sample.flags |= Flag::kSlaveFollows;
                }},
    cell<&CycleSample::sync_base, Flag::kSyncBaseValid>(Signal::kSyncBase),
    cell<&CycleSample::stamp_doubt_ns>(Signal::kStampDoubt),
    cell<&CycleSample::external_error_ns>(Signal::kExternalError),
};

template <class Take>
void each_cell(std::string_view line, Take&& take) {
  for (std::size_t column = 0;; ++column) {
    const auto end = line.find(',');
    take(column, line.substr(0, end));
    if (end == std::string_view::npos) return;
    line.remove_prefix(end + 1);
  }
}

/// The columns of a table by their names.
class RunTable {
 public:
  explicit RunTable(std::string_view header) {
    each_cell(header, [this](std::size_t, std::string_view name) {
      const auto* row = find_signal(name, SignalInfo::Scope::kBus);
      columns_.push_back(row == nullptr ? std::nullopt : std::optional(row->id));
      if (row != nullptr) needed_ = columns_.size();
    });
  }
  [[nodiscard]] bool has(Signal signal) const { return std::ranges::find(columns_, signal) != columns_.end(); }
  /// Why the line is none; empty: it is.
  Reason read(std::string_view line, CycleSample& sample) {
    in_sync_ = master_in_sync_ = kNoCell;
    Reason wrong;
    std::size_t count = 0;
    each_cell(line, [&](std::size_t column, std::string_view text) {
      ++count;
      if (!wrong.empty() || text.empty() || column >= columns_.size() || !columns_[column]) return;
      if (!put(*columns_[column], text, sample)) wrong = because("\"{text}\" is no number", text.substr(0, 40));
    });
    if (wrong.empty() && count < needed_) wrong = because("of {other} cells it has only {count}", needed_, count);
    const bool answered = (sample.flags & Flag::kFrameLost) == 0 && is_told(sample, kFramesUntold);
    if (answered && sample.wkc_received != sample.wkc_expected) sample.flags |= Flag::kWkcError;
    sample.slaves_sync = verdict(slaves_, in_sync_, has(Signal::kDcInSync));
    sample.master_sync = verdict(master_, master_in_sync_, has(Signal::kDcmInSync));
    return wrong;
  }

 private:
  bool put(Signal signal, std::string_view text, CycleSample& sample) {
    double real = 0;
    std::int64_t whole = 0;
    const auto* end = text.data() + text.size();
    const auto as_whole = std::from_chars(text.data(), end, whole);
    if (as_whole.ec != std::errc() || as_whole.ptr != end) {
      const auto as_real = std::from_chars(text.data(), end, real);
      if (as_real.ec != std::errc() || as_real.ptr != end || !std::isfinite(real)) return false;
      whole = std::llround(std::clamp(real, -9e18, 9e18));
    } else {
      real = static_cast<double>(whole);
    }
    if (signal == Signal::kCycle) sample.cycle = static_cast<std::uint64_t>(std::max<std::int64_t>(whole, 0));
    if (signal == Signal::kDcInSync) in_sync_ = whole != 0 ? 1 : 0;
    if (signal == Signal::kDcmInSync) master_in_sync_ = whole != 0 ? 1 : 0;
    const auto* found = std::ranges::find(kTableColumns, signal, &TableColumn::signal);
    if (found != kTableColumns.end()) found->put(sample, whole, real);
    return true;
  }
  /// An empty cell: it was not monitored, or there is no master synchronisation.
  static SyncState verdict(Verdict& of, int cell, bool told) {
    if (told && cell == kNoCell) return SyncState::kNotMonitored;
    return told ? of.of(cell != 0) : SyncState::kUnknown;
  }

  static constexpr int kNoCell = -1;

  std::vector<std::optional<Signal>> columns_;
  std::size_t needed_ = 0;  // cells of a line, up to the last one that is known
  Verdict slaves_{true}, master_{true};
  int in_sync_ = kNoCell, master_in_sync_ = kNoCell;  // cells of the line
};

std::uint16_t untold_of(const RunTable& table) {
  std::uint16_t flags = kStateUntold | kLearnedUntold;
  if (!table.has(Signal::kLateness)) flags |= kLatenessUntold;
  if (!table.has(Signal::kRoundTrip)) flags |= kRoundTripUntold;
  if (!table.has(Signal::kFrameLost) || !table.has(Signal::kWkcExpected)) flags |= kFramesUntold | kExpectedUntold;
  return flags;
}

std::string_view next_line(std::string_view& text) {
  const auto end = text.find('\n');
  auto line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

Result<ImportedRun> import_run_table(std::string_view text, const std::string& name) {
  RunTable table(next_line(text));
  ImportedRun run;
  const auto untold = untold_of(table);
  int slaves = 0;
  for (int number = 2; !text.empty(); ++number) {
    const bool ended = text.find('\n') != std::string_view::npos;
    const auto line = next_line(text);
    if (line.empty()) continue;
    CycleSample sample;
    sample.flags = untold;
    auto wrong = table.read(line, sample);
    for (const auto time : {sample.send_time, sample.reference_time}) {
      if (wrong.empty() && !is_time(time)) wrong = because("its time {time} ns is no date of this century", time);
    }
    if (wrong.empty() && !run.samples.empty() && sample.cycle <= run.samples.back().cycle)
      wrong = because("its cycle {cycle} does not come behind that of the line before", sample.cycle);
    if (!ended) run.findings.push_back(unended(number, wrong.empty()));
    if (!wrong.empty() && !ended) break;
    if (!wrong.empty()) {
      return fail(Error{.code = ErrorCode::kMalformedData,
                        .subject = fmt::format("line {} of the table", number),
                        .detail = wrong,
                        .file = name,
                        .line = number});
    }
    slaves = std::max({slaves, sample.slave_position + 1, sample.sm2_position + 1});
    run.samples.push_back(sample);
  }
  if (run.samples.empty()) return no_cycles(name, because("it has no rows"));
  run.about.program = "import of the table of a run";
  for (int slave = 0; slave < slaves; ++slave) run.about.slaves.push_back({fmt::format("Slave {}", slave), 0, 0, 0});
  if (!table.has(Signal::kDcInSync) || !table.has(Signal::kDcmInSync)) run.about.armed = run.samples.front().send_time;
  return run;
}

Status write_all(const ImportedRun& run, RecordingWriter& writer) {
  constexpr std::size_t kPortion = 1U << 14;
  for (std::size_t i = 0; i < run.samples.size(); i += kPortion) {
    const auto end = std::min(i + kPortion, run.samples.size());
    RecordingBatch batch;
    batch.samples.assign(run.samples.begin() + static_cast<std::ptrdiff_t>(i),
                         run.samples.begin() + static_cast<std::ptrdiff_t>(end));
    if (auto status = writer.write(batch); !status) return status;
  }
  return writer.finish("end of the file", recorded(run.findings));
}

}  // namespace

std::optional<TableKind> table_kind(std::string_view text) {
  text = without_mark(text);
  const auto line = text.substr(0, text.find('\n'));
  if (line.starts_with("cycle,send_time_ns,")) return TableKind::kRunTable;
  const auto known = read_dcm_table(line);
  return known && known->has("CtlErr [ns]") ? std::optional(TableKind::kDcmLog) : std::nullopt;
}

Result<ImportedRun> import_table(std::string_view text, const std::string& name, const ImportLimits& limits) {
  text = without_mark(text);
  const auto kind = table_kind(text);
  if (!kind) {
    return fail(Error{
        .code = ErrorCode::kNotThatKindOfFile,
        .detail = because("a log of the master synchronisation, or the table that \"synclinectl run --csv\" writes"),
        .file = name});
  }
  auto run = *kind == TableKind::kDcmLog ? import_dcm_log(text, name) : import_run_table(text, name);
  if (!run) return run;
  run->about.link = name;
  const auto cycle = cycle_time_of(run->samples);
  run->about.limits = {cycle > 0 ? cycle : kMillisecond, limits.deviation_ns, limits.dcm_error_ns};
  return run;
}

ReplayedRun replayed(const ImportedRun& run) {
  NetworkConfig config;
  for (const auto& slave : run.about.slaves) config.slaves.emplace_back().name = slave.name;
  const auto capacity = std::min(run.samples.size(), ReplayOptions::kMostCycles);
  ReplayedRun replayed{std::make_unique<RunRecord>(std::move(config), std::max<std::size_t>(capacity, 1),
                                                   run.about.limits, run.about.speed_counter_start),
                       {}};
  auto& info = replayed.info;
  info.about = run.about;
  info.ended = "end of the file";
  info.cycles = run.samples.size();
  info.begin = run.samples.front().send_time;
  info.end = run.samples.back().send_time;
  auto& record = *replayed.record;
  record.reserve(capacity);
  if (run.about.armed) record.arm_from(*run.about.armed);
  record.add(run.samples);
  record.restore(run.findings);
  info.findings = recorded(run.findings);
  info.missing_cycles = record.samples().missing_cycles();
  return replayed;
}

Status may_write_recording(const std::string& path) { return check_new_recording(path); }

Status write_recording(const ImportedRun& run, const std::string& path) {
  auto writer = RecordingWriter::create(path, run.about);
  if (!writer) return tl::unexpected(writer.error());
  auto status = write_all(run, *writer);
  if (status) return status;
  writer = tl::unexpected(status.error());  // closed before its file goes: half of an import is none
  remove_database(path);
  return status;
}

}  // namespace syncline
