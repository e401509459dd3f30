// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "master/channels.h"
#include "support/types.h"
#include "trace/sample_table.h"

/// The history of the samples that a window or a statistic looks at.
namespace syncline::trace {

enum class SeriesKind : std::uint8_t {
  kLateness,          // ns, wake-up against schedule
  kRoundTrip,         // ns
  kDcmError,          // ns, raw
  kDcmErrorFiltered,  // ns
  kDcmAdjust,         // ns
  kDrift,             // ppm
  kDeviation,         // ns, wire-ored 0x092C: an upper estimate over all slaves
  kMissingWkc,        // working counter expected minus received, process data
  kSlaveDeviation,    // ns, signed 0x092C of one slave
  kSm2Missed,         // counter of one slave, a step series
};

/// One series; `slave` is the position for the two kinds that belong to a slave, else -1.
struct SeriesId {
  SeriesKind kind = SeriesKind::kDeviation;
  int slave = -1;
  auto operator<=>(const SeriesId&) const = default;
};

[[nodiscard]] std::string_view series_name(SeriesKind kind);  // "dcm_error", stable, for files
[[nodiscard]] std::string_view series_unit(SeriesKind kind);  // "ns", "ppm", ""
[[nodiscard]] bool is_slave_series(SeriesKind kind);
/// A step series holds its value until the next reading.
[[nodiscard]] bool is_step_series(SeriesKind kind);

/// One column of a plot.
struct TraceColumn {
  double min = 0;
  double max = 0;
  bool valid = false;  // there is a value (a step series holds its last one)
  bool gap = false;    // no value because something is missing; !valid && !gap = between two readings
  bool operator==(const TraceColumn&) const = default;
};

/// Columns on an absolute lattice: column i covers [first + i * width, first + (i + 1) * width) and
/// `first` is a multiple of `width`, so a window that scrolls keeps its columns' content.
struct TraceColumns {
  Nanoseconds first = 0;
  Nanoseconds width = 1;
  std::vector<TraceColumn> columns;
  [[nodiscard]] Nanoseconds begin_of(std::size_t column) const {
    return first + static_cast<Nanoseconds>(column) * width;
  }
};

/// One reading; `valid` false stands for the place where a gap begins (value 0).
struct TracePoint {
  Nanoseconds time = 0;
  double value = 0;
  bool valid = true;
  bool operator==(const TracePoint&) const = default;
};

struct SampleStoreOptions {
  std::size_t cycle_capacity = std::size_t{1} << 22;  // samples kept of the series that have one a cycle
  std::size_t slave_capacity = std::size_t{1} << 18;  // readings kept of each slave's series
  Nanoseconds cycle_gap = 10 * kMillisecond;          // a longer silence is a gap; 2 to 3 cycle times are good
  Nanoseconds slave_gap = 10 * kSecond;               // the same for the round-robin readings
};

/// Append-only history of CycleSamples, bounded in samples (the oldest go in blocks of 4096), with a
/// min/max pyramid, so that a query costs by its columns and not by the samples it spans, and no spike
/// is lost. Times are CycleSample::send_time (host clock, DC epoch). Not thread-safe: the thread that
/// drains the sample ring owns it.
class SampleStore {
 public:
  explicit SampleStore(const SampleStoreOptions& options = {});

  void append(const CycleSample& sample);
  void append(std::span<const CycleSample> samples);
  /// Forgets everything; for a new session.
  void clear();
  /// What counts as a gap in the series that have one sample a cycle (e.g. 2.5 cycle times).
  void set_cycle_gap(Nanoseconds gap) { options_.cycle_gap = gap; }

  [[nodiscard]] bool empty() const { return cycles_.rows() == 0; }
  [[nodiscard]] std::size_t cycle_count() const { return cycles_.rows(); }  // kept
  /// Samples refused because their time did not rise.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }
  [[nodiscard]] Nanoseconds begin_time() const;  // oldest kept sample, 0 when empty
  [[nodiscard]] Nanoseconds end_time() const;    // newest sample, 0 when empty
  /// Slaves that have readings of `kind`, ascending.
  [[nodiscard]] std::vector<int> slaves(SeriesKind kind) const;
  /// Newest value of the series.
  [[nodiscard]] std::optional<TracePoint> latest(SeriesId id) const;

  /// Min/max columns that cover [begin, end) with at most `columns` + 1 columns, each
  /// ceil((end - begin) / columns) ns wide (at least 1). Fills `out`, whose memory is reused. An
  /// unknown slave gives columns that are gaps.
  void query(SeriesId id, Nanoseconds begin, Nanoseconds end, std::size_t columns, TraceColumns& out) const;
  [[nodiscard]] TraceColumns query(SeriesId id, Nanoseconds begin, Nanoseconds end, std::size_t columns) const;

  /// Smallest and largest value in [begin, end), nothing when there is none; for scaling axes.
  [[nodiscard]] std::optional<TraceColumn> range(SeriesId id, Nanoseconds begin, Nanoseconds end) const;

  /// The readings in [begin, end) and the one before and behind it, for short windows; gaps are
  /// single points with valid == false. Never more than `at_most` readings (the newest); use
  /// count_points() to choose between points and columns.
  void points(SeriesId id, Nanoseconds begin, Nanoseconds end, std::vector<TracePoint>& out,
              std::size_t at_most = 100'000) const;
  /// Rows in [begin, end) of the table the series lives in.
  [[nodiscard]] std::size_t count_points(SeriesId id, Nanoseconds begin, Nanoseconds end) const;

 private:
  struct Source {
    const SampleTable* table = nullptr;
    std::size_t column = 0;
    double scale = 1;
    Nanoseconds gap = 0;
    bool step = false;
  };
  [[nodiscard]] Source source_of(SeriesId id) const;
  void append_slave(SeriesId id, Nanoseconds time, std::int64_t value);

  SampleStoreOptions options_;
  SampleTable cycles_;
  std::map<SeriesId, SampleTable> slaves_;
  std::uint64_t refused_ = 0;
};

}  // namespace syncline::trace
