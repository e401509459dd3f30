// SPDX-License-Identifier: Apache-2.0
#include "capture/import_capture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "capture/capture_source.h"
#include "capture/pcap_reader.h"
#include "findings/recording_words.h"
#include "findings/sentence.h"
#include "link/link.h"
#include "protocol/datagram.h"
#include "protocol/frame.h"
#include "protocol/registers.h"
#include "protocol/system_time_difference.h"
#include "reasons/because.h"
#include "record/import_run.h"
#include "trace/untold.h"

namespace syncline {
namespace {

using Flag = CycleSample::Flag;

constexpr Nanoseconds kOldReading = kSecond;
constexpr std::size_t kMostUnderWay = 256;  // frames under way; what is older was lost

/// What makes a frame one of the process data: its first logical command, else the reading of the reference clock.
struct FrameKey {
  Command command = Command::kNop;
  std::uint32_t address = 0;
  std::uint16_t length = 0;
  auto operator<=>(const FrameKey&) const = default;
};

constexpr std::uint64_t kFramesATelling = 4096;

struct StationReading {
  std::uint16_t station = 0;
  std::int32_t deviation_ns = 0;
};

/// A frame, and what it brought back.
struct Exchange {
  Nanoseconds sent = 0;
  std::optional<Nanoseconds> returned;
  bool by_probe = false;        // stamped by one
  std::optional<FrameKey> key;  // nothing: no process data
  std::uint32_t wkc = 0;        // of the logical commands
  std::optional<std::uint64_t> system_time;
  bool system_time_is_whole = false;  // of 64 bits
  std::optional<std::uint16_t> reference;
  std::optional<std::uint32_t> deviation_ored;
  std::vector<StationReading> readings;
};

struct Captured {
  std::vector<Exchange> exchanges;
  bool has_both_ways = false;
  std::uint64_t by_host = 0, by_probe = 0;  // EtherCAT frames that these stamped
};

bool reads_clock(const DatagramHeader& header) {
  return (header.command == Command::kFrmw || header.command == Command::kArmw) && header.ado() == reg::kSystemTime;
}

std::optional<FrameKey> key_of(std::span<const DatagramHeader> headers) {
  const auto logical = std::ranges::find_if(headers, [](const auto& header) { return is_logical(header.command); });
  if (logical != headers.end()) return FrameKey{logical->command, logical->address, logical->length};
  const auto clock = std::ranges::find_if(headers, reads_clock);
  if (clock != headers.end()) return FrameKey{clock->command, clock->address, clock->length};
  return std::nullopt;
}

/// The bytes of a register out of what a datagram has read.
std::optional<std::span<const std::uint8_t>> part_of(const DatagramView& datagram, std::uint16_t address,
                                                     std::size_t length) {
  const auto begin = datagram.header.ado();
  if (begin > address || std::size_t{begin} + datagram.data.size() < std::size_t{address} + length) return std::nullopt;
  return datagram.data.subspan(static_cast<std::size_t>(address - begin), length);
}

void learn(Exchange& exchange, const DatagramView& datagram) {
  const auto& header = datagram.header;
  if (is_logical(header.command)) exchange.wkc += datagram.wkc();
  if (datagram.wkc() == 0 || is_logical(header.command)) return;
  if (reads_clock(header) && datagram.data.size() >= 4) {
    exchange.system_time_is_whole = datagram.data.size() >= 8;
    exchange.system_time = exchange.system_time_is_whole ? load_le<std::uint64_t>(datagram.data)
                                                         : std::uint64_t{load_le<std::uint32_t>(datagram.data)};
    if (header.command == Command::kFrmw) exchange.reference = header.adp();
  }
  const bool reads_one = header.command == Command::kFprd;
  if (!reads_one && header.command != Command::kBrd) return;
  const auto difference = part_of(datagram, reg::kSystemTimeDifference, 4);
  if (!difference) return;
  const SystemTimeDifference value{load_le<std::uint32_t>(*difference)};
  if (!reads_one) {
    exchange.deviation_ored = value.magnitude();
  } else {
    const auto limited = std::clamp<std::int64_t>(value.signed_value(), INT32_MIN, INT32_MAX);
    exchange.readings.push_back({header.adp(), static_cast<std::int32_t>(limited)});
  }
}

/// Puts frames and their answers together as they come.
class Pairing {
 public:
  /// Stamps of a probe count from when it was switched on: the date is the first frame's.
  Nanoseconds time_of(const CapturedFrame& frame) {
    if (!frame.stamp) return frame.time;
    if (!probe_epoch_) probe_epoch_ = frame.time - *frame.stamp;
    return *probe_epoch_ + *frame.stamp;
  }

  /// kFileNotReadable and its like are the reader's.
  void add(CapturedFrame& frame) {
    if (frame.truncated) return;
    FrameReader reader(frame.bytes);
    if (!reader.is_ethercat()) return;
    Open open;
    std::copy_n(frame.bytes.begin() + 6, 6, open.source.begin());
    std::vector<DatagramView> views;
    while (auto datagram = reader.next()) {
      open.headers.push_back(datagram->header);
      views.push_back(*datagram);
    }
    if (reader.malformed() || views.empty()) return;
    const auto time = time_of(frame);
    ++(frame.stamp ? captured_.by_probe : captured_.by_host);
    if (const auto request = find_request(open)) {
      auto& exchange = captured_.exchanges[*request];
      exchange.returned = time;
      captured_.has_both_ways = true;
      for (const auto& view : views) learn(exchange, view);
      return;
    }
    if (open_.size() == kMostUnderWay) open_.erase(open_.begin());
    open.exchange = captured_.exchanges.size();
    auto& exchange = captured_.exchanges.emplace_back();
    exchange.sent = time;
    exchange.by_probe = frame.stamp.has_value();
    exchange.key = key_of(open.headers);
    // Where only the way back was captured nothing else tells what came; of frames on their way out all counters are 0.
    if ((open.source[0] & kLocallyAdministered) != 0) {
      unpaired_.push_back({open.exchange, {}});
      for (const auto& view : views) learn(unpaired_.back().told, view);
    }
    open_.push_back(std::move(open));
  }
  Captured take() {
    if (captured_.has_both_ways) return std::move(captured_);
    Captured back{{}, false, captured_.by_host, captured_.by_probe};
    for (auto& [number, told] : unpaired_) {
      told.sent = captured_.exchanges[number].sent;
      told.by_probe = captured_.exchanges[number].by_probe;
      told.key = captured_.exchanges[number].key;
      back.exchanges.push_back(std::move(told));
    }
    return back;
  }

 private:
  struct Open {
    std::array<std::uint8_t, 6> source{};
    std::vector<DatagramHeader> headers;
    std::size_t exchange = 0;
  };
  struct Unpaired {
    std::size_t exchange = 0;
    Exchange told;
  };

  std::optional<std::size_t> find_request(const Open& back) {
    const auto is_same = [](const DatagramHeader& sent, const DatagramHeader& came) {
      // Auto-increment and broadcast addresses were counted up on the way.
      return sent.command == came.command && sent.index == came.index && sent.length == came.length &&
             sent.ado() == came.ado();
    };
    for (auto i = open_.size(); i > 0; --i) {
      const auto& sent = open_[i - 1];
      auto marked = sent.source;  // by the first slave; a master whose address has the bit leaves no difference
      marked[0] |= kLocallyAdministered;
      if (marked != back.source || !std::ranges::equal(sent.headers, back.headers, is_same)) continue;
      const auto number = sent.exchange;
      open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(i - 1));
      return number;
    }
    return std::nullopt;
  }

  Captured captured_;
  std::vector<Open> open_;
  std::vector<Unpaired> unpaired_;
  std::optional<Nanoseconds> probe_epoch_;
};

/// That of most frames; of several as many the one that came first.
std::optional<FrameKey> main_key(const std::vector<Exchange>& exchanges) {
  std::map<FrameKey, std::size_t> counts;
  for (const auto& exchange : exchanges) {
    if (exchange.key) ++counts[*exchange.key];
  }
  const auto is_data = [](const FrameKey& key) { return is_logical(key.command); };
  const bool any_data = std::ranges::any_of(counts, [&](const auto& count) { return is_data(count.first); });
  std::optional<FrameKey> best;
  std::size_t most = 0;
  for (const auto& exchange : exchanges) {
    if (!exchange.key || (any_data && !is_data(*exchange.key))) continue;
    const auto count = counts[*exchange.key];
    if (count > most) {
      most = count;
      best = exchange.key;
    }
  }
  return best;
}

/// Deviations of slaves by their stations, without that of their reference clock.
class Stations {
 public:
  explicit Stations(const std::vector<Exchange>& exchanges) {
    std::optional<std::uint16_t> reference;
    for (const auto& exchange : exchanges) {
      for (const auto& reading : exchange.readings) numbers_.emplace(reading.station, 0);
      if (exchange.reference) reference = exchange.reference;
    }
    if (reference) numbers_.erase(*reference);  // what it shows is no deviation
    int next = 0;
    for (auto& [station, number] : numbers_) number = next++;
    latest_.resize(numbers_.size());
  }
  [[nodiscard]] std::vector<RecordingSlave> slaves() const {
    std::vector<RecordingSlave> all;
    for (const auto& [station, number] : numbers_) all.push_back({fmt::format("Station {}", station), 0, 0, 0});
    return all;
  }
  void put(CycleSample& sample, const StationReading& reading) {
    const auto found = numbers_.find(reading.station);
    if (found == numbers_.end()) return;
    const int number = found->second;
    sample.slave_position = static_cast<std::int16_t>(number);
    sample.slave_deviation_ns = reading.deviation_ns;
    sample.flags |= Flag::kSlaveFollows;
    latest_[static_cast<std::size_t>(number)] = {
        sample.send_time, static_cast<std::uint32_t>(std::abs(std::int64_t{reading.deviation_ns}))};
  }
  /// Of the latest readings of all that follow.
  [[nodiscard]] std::optional<std::uint32_t> largest(Nanoseconds now) const {
    std::optional<std::uint32_t> most;
    for (const auto& one : latest_) {
      if (one.time != 0 && now - one.time < kOldReading) most = std::max(most.value_or(0), one.magnitude);
    }
    return most;
  }

 private:
  std::map<std::uint16_t, int> numbers_;
  struct Latest {
    Nanoseconds time = 0;  // 0: none yet
    std::uint32_t magnitude = 0;
  };
  std::vector<Latest> latest_;
};

/// The cycles of a capture, one after the other.
class CycleMaker {
 public:
  CycleMaker(const FrameKey& main, Stations& stations, bool has_both_ways)
      : main_(main), stations_(stations), has_both_ways_(has_both_ways) {}

  void add(const Exchange& exchange) {
    if (exchange.key == main_) begin(exchange);
    if (samples_.empty()) return;
    auto& sample = samples_.back();
    if (exchange.key && has_both_ways_ && !exchange.returned) {
      ++sample.frames_lost;
      if (exchange.key == main_) sample.flags |= Flag::kFrameLost;
    }
    sample.wkc_received =
        static_cast<std::uint16_t>(std::min<std::uint32_t>(sample.wkc_received + exchange.wkc, UINT16_MAX));
    if (exchange.system_time) put_system_time(sample, exchange);
    if (exchange.deviation_ored) {
      sample.flags |= Flag::kDeviationValid;
      sample.deviation_ored_ns = *exchange.deviation_ored;
    }
    // A sample has room for one.
    if (!exchange.readings.empty() && sample.slave_position < 0) stations_.put(sample, exchange.readings.front());
  }
  std::vector<CycleSample> take() {
    if (!samples_.empty()) finish(samples_.back());
    // The capture was ended while they were under way.
    while (!samples_.empty() && (samples_.back().flags & Flag::kFrameLost) != 0) samples_.pop_back();
    return std::move(samples_);
  }

 private:
  void begin(const Exchange& exchange) {
    if (!samples_.empty()) finish(samples_.back());
    auto& sample = samples_.emplace_back();
    sample.send_time = exchange.sent;
    sample.stamped_by = exchange.by_probe ? StampSource::kProbe : StampSource::kCapture;
    sample.flags = kStateUntold | kLatenessUntold | kExpectedUntold;
    sample.slaves_sync = sample.master_sync = SyncState::kUnknown;
    if (!has_both_ways_) sample.flags |= kRoundTripUntold | kFramesUntold;
    if (exchange.returned) {
      const auto trip = std::clamp<Nanoseconds>(*exchange.returned - exchange.sent, 0, INT32_MAX);
      sample.round_trip_ns = static_cast<std::int32_t>(trip);
    }
  }
  void finish(CycleSample& sample) const {
    // What is or-ed is of all clocks, that of reference among them: an upper estimate where nobody is read by himself.
    auto largest = stations_.largest(sample.send_time);
    if (!largest && (sample.flags & Flag::kDeviationValid) != 0) largest = sample.deviation_ored_ns;
    if (!largest) return;
    sample.flags |= Flag::kFollowersRead;
    sample.deviation_ns = *largest;
  }
  /// Of 32 bits the rest is that of the time before, or nearest to the host's.
  void put_system_time(CycleSample& sample, const Exchange& exchange) {
    auto time = static_cast<Nanoseconds>(*exchange.system_time);
    if (!exchange.system_time_is_whole) {
      const auto near = clock_ != 0 ? clock_ : sample.send_time;
      const auto low = static_cast<std::uint32_t>(*exchange.system_time);
      time = near + static_cast<std::int32_t>(low - static_cast<std::uint32_t>(near));
    }
    if (time <= 0) return;
    clock_ = time;
    sample.reference_time = time;
    sample.flags |= Flag::kReferenceValid;
  }

  FrameKey main_;
  Stations& stations_;
  bool has_both_ways_;
  Nanoseconds clock_ = 0;  // system time, read last; 0: not yet
  std::vector<CycleSample> samples_;
};

/// Who stamped the frames, and what of their replies is not there.
void tell_source(const Captured& captured, const std::optional<FrameKey>& main, std::vector<Finding>& findings) {
  using words::kRecording;
  if (captured.by_probe == 0) {
    findings.push_back(make_finding<kRecording>("import-times", {}));
  } else if (captured.by_host == 0) {
    findings.push_back(make_finding<kRecording>("import-times/probe", {}));
  } else {
    findings.push_back(make_finding<kRecording>("import-times/mixed", {}, fig::count<"count">(captured.by_probe),
                                                fig::count<"frames">(captured.by_probe + captured.by_host)));
  }
  if (!captured.has_both_ways) {
    findings.push_back(make_finding<kRecording>("import-replies-missing/back", {}));
    return;
  }
  std::uint64_t cyclic = 0, missing = 0;
  for (const auto& exchange : captured.exchanges) {
    if (exchange.key != main) continue;
    ++cyclic;
    missing += exchange.returned ? 0U : 1U;
  }
  // The last ones may have been under way when the capture was ended.
  if (missing > 1) {
    findings.push_back(make_finding<kRecording>("import-replies-missing", {}, fig::count<"count">(missing),
                                                fig::count<"frames">(cyclic)));
  }
}

}  // namespace

Result<ImportedRun> import_capture(const std::string& path, const ImportLimits& limits,
                                   const ImportProgress& progress) {
  auto reader = PcapReader::open(path);
  if (!reader) return tl::unexpected(reader.error());
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  Pairing pairing;
  CaptureSource source;
  ImportedRun run;
  std::uint64_t frames = 0, taken = 0, in_part = 0;
  Nanoseconds first = 0, last = 0;
  for (;;) {
    auto frame = reader->next();
    if (!frame && frames == 0) return tl::unexpected(frame.error());
    if (!frame) {
      run.findings.push_back(make_finding<words::kRecording>("import-capture-cut", {}, fig::count<"frames">(frames),
                                                             fig::reason<"reason">(frame.error().detail)));
      break;
    }
    if (!*frame) break;
    const bool tell = progress && frames % kFramesATelling == 0;
    if (tell && !progress(reader->read_bytes(), error ? 0 : size)) return fail(ErrorCode::kCancelled, path);
    const auto time = pairing.time_of(**frame);
    if (frames == 0) first = time;
    last = std::max(time, last);
    ++frames;
    if (time - first < limits.from) continue;
    if ((limits.until > 0 && time - first >= limits.until) || (limits.most_frames > 0 && taken == limits.most_frames))
      break;
    ++taken;
    in_part += (*frame)->truncated ? 1U : 0U;
    if (source.add((*frame)->bytes, time)) pairing.add(**frame);
  }
  if (frames > 0 && taken == 0) {
    return fail(ErrorCode::kBadValue, "the range",
                because("it holds nothing of the recording, which is {time} s long",
                        fmt::format("{:.3f}", static_cast<double>(last - first) / 1e9)));
  }
  if (in_part > 0)
    run.findings.push_back(make_finding<words::kRecording>("import-frames-cut", {}, fig::count<"count">(in_part)));
  const auto captured = pairing.take();
  const auto name = std::filesystem::path(path).filename().string();
  const auto main = main_key(captured.exchanges);
  if (main) {
    Stations stations(captured.exchanges);
    run.about.slaves = stations.slaves();
    CycleMaker maker(*main, stations, captured.has_both_ways);
    for (const auto& exchange : captured.exchanges) maker.add(exchange);
    run.samples = maker.take();
  }
  if (run.samples.empty()) return fail(ErrorCode::kBadValue, name, because("it holds no cyclic frame that came back"));
  tell_source(captured, main, run.findings);
  source.tell(run.findings);
  count_cycles(run.samples);
  run.about.program = "import of a capture";
  run.about.link = name;
  run.about.armed = run.samples.front().send_time;
  const auto cycle = cycle_time_of(run.samples);
  run.about.limits = {cycle > 0 ? cycle : kMillisecond, limits.deviation_ns, limits.dcm_error_ns};
  return run;
}

}  // namespace syncline
