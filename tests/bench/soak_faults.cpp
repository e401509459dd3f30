// SPDX-License-Identifier: Apache-2.0
// soak_faults [HOURS [FAULTS [SEED [line|drawn|pairs|tree [loud]]]]]: one master on one simulated machine for so many
// virtual hours (24), brought up anew for each of so many faults (200) of every kind at random times. Each must be told
// by its kind and be seen in the plots, nothing else accused or seen there, and the memory stay what it was. With pairs
// another fault comes minutes after the first, and both are told in one report. The machine is a line of six, or one
// drawn by the seed: a branch with up to twelve more, some without SYNC0 or without a clock, clocks of 32 bits, another
// reference clock, a second task, a branch that may be unplugged, noisy latches, cables whose ways differ, another
// cycle time, limit, mode and host; or a tree of any shape, led by any of its clocks. Exit code 1 when a promise is
// missed.
#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/cli.h"
#include "app/cli/event_text.h"
#include "bench/soak_fault_kinds.h"
#include "bench/soak_machine.h"
#include "bench/soak_plots.h"
#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/master_channels.h"
#include "compile/compile.h"
#include "config/sync_grid.h"
#include "diagnosis/run_diagnosis.h"
#include "findings/error_text.h"
#include "link/simulated_host.h"
#include "master/master_service.h"
#include "support/random.h"
#include "trace/run_report.h"

namespace syncline::bench {
namespace {

/// Long enough for every machine to be in OP and in sync; a reference clock that is led to an external one goes half a
/// cycle at 8 ppm.
Nanoseconds bring_up(DcmMode mode) { return mode == DcmMode::kDcx ? 150 * kSecond : 30 * kSecond; }

/// Without what the allocator keeps for later: the store of a segment comes and goes.
double resident_mb() {
  ::malloc_trim(0);
  std::ifstream in("/proc/self/statm");
  std::size_t size = 0, resident = 0;
  in >> size >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

struct Thrown {
  FaultConfig fault;
  const SoakFaultKind* kind = nullptr;
  bool told = false, shown = true;
  Nanoseconds next = INT64_MAX;  // when another one comes
  bool down = false;             // its victim, by what came before: nothing need be told of it

  [[nodiscard]] bool concerns(int slave) const { return fault.slave < 0 || slave < 0 || slave == fault.slave; }
};

/// What was thrown in between two bring-ups, and what came out of it.
struct Segment {
  std::vector<Thrown> thrown{};
  std::vector<std::string> accused{},
      strange{};  // beyond what the kinds bring with them: findings, signals in the plots
  std::string log{};

  [[nodiscard]] bool kept() const {
    return accused.empty() && strange.empty() &&
           std::ranges::all_of(thrown, [](const Thrown& one) { return one.told && one.shown; });
  }
};

enum class Way { kLine, kDrawn, kPairs, kTree };

SoakShape shape_of(Way way) {
  return way == Way::kLine ? SoakShape::kLine : way == Way::kTree ? SoakShape::kTree : SoakShape::kDrawn;
}

template <class Range, class Value>
bool holds(const Range& range, const Value& value) {
  return std::ranges::find(range, value) != range.end();
}

class Soak {
 public:
  Soak(double hours, int faults, std::uint64_t seed, Way way)
      : random_(seed),
        machine_(soak_machine(random_, shape_of(way))),
        kinds_(kinds_for(machine_)),
        length_(static_cast<Nanoseconds>(hours * 3.6e12 / faults)) {
    begin_ = clock_.now();
    network_.sim.seed = seed;
    for (int i = 0; i < faults; ++i) add_segment(way == Way::kPairs);
    const auto host = set_up_host(clock_, network_.sim);
    auto bus = sim::SimBus::create(network_.sim, begin_);
    auto link = bus ? make_simulated_link("sim", std::move(*bus), clock_, host) : nullptr;
    service_ = std::make_unique<MasterService>(std::move(link), clock_);
  }

  int run(bool loud) {
    fmt::print("{}\n", text_of(machine_));
    if (const auto result = compile(network_.project); !result) {
      fmt::print(stderr, "this machine does not compile: {}\n", describe(result.error()));
      return 2;
    }
    double at_first = 0, most = 0;
    const auto settled = std::min<std::size_t>(20, segments_.size() / 2);
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      run_segment(i);
      count(segments_[i]);
      if (loud || !segments_[i].kept()) show(i);
      segments_[i].log.clear();
      const double resident = resident_mb();
      if (i == settled) at_first = resident;
      if (i >= settled) most = std::max(most, resident);
    }
    return report(at_first, most);
  }

 private:
  [[nodiscard]] Nanoseconds start_of(std::size_t segment) const { return static_cast<Nanoseconds>(segment) * length_; }

  [[nodiscard]] DcmMode mode_of(std::size_t segment) const { return machine_.modes[segment % machine_.modes.size()]; }

  void add_segment(bool pair) {
    const auto& first = *kinds_[segments_.size() % kinds_.size()];
    const auto start = start_of(segments_.size());
    segments_.emplace_back();
    const auto takes = bring_up(mode_of(segments_.size() - 1)), up = start + takes;
    if (!pair || first.while_down) return throw_in(first, up, up + (length_ - takes) / 2);
    throw_in(first, up, up + (length_ - takes) / 5);
    const auto* second = kinds_[random_.next() % kinds_.size()];
    while (second->while_down) second = kinds_[random_.next() % kinds_.size()];
    throw_in(*second, up + (length_ - takes) * 3 / 5, up + (length_ - takes) * 3 / 4);
  }

  /// Into the last segment, at a time between these two.
  void throw_in(const SoakFaultKind& kind, Nanoseconds earliest, Nanoseconds latest) {
    const auto start = start_of(segments_.size() - 1);
    FaultConfig fault;
    fault.kind = kind.kind;
    fault.at = kind.while_down
                   ? start + kSecond
                   : earliest + static_cast<Nanoseconds>(random_.uniform(0, static_cast<double>(latest - earliest)));
    const auto whom = victims(machine_, kind);
    if (!whom.empty()) fault.slave = whom[random_.next() % whom.size()];
    if (kind.longest > 0) {
      fault.until = fault.at + static_cast<Nanoseconds>(random_.uniform(static_cast<double>(kind.shortest),
                                                                        static_cast<double>(kind.longest)));
    }
    // Who runs by himself is looked at in turn, in cycles.
    if (kind.by_itself && network_.project.master.cycle_time > 2 * kMillisecond) fault.until += 6 * kSecond;
    if (kind.while_down) fault.until = start + length_ - kSecond;
    fault.count = 1 + static_cast<std::uint32_t>(random_.next() % kind.most_count);
    fault.value_ns =
        static_cast<Nanoseconds>(random_.uniform(static_cast<double>(kind.least), static_cast<double>(kind.most)));
    if (kind.either_sign && random_.next() % 2 == 0) fault.value_ns = -fault.value_ns;
    if (kind.in_cycles) fault.value_ns = fault.value_ns * own_cycle(machine_, fault.slave) / kMillisecond;
    fault.ppm = kind.ppm;
    fault.probability = kind.probability;
    fault.port = kind.port;
    fault.state = kind.state;
    fault.code = kind.code;
    fault.period = kind.period;
    // Who comes back in a tree may have to be set up anew.
    const bool goes = fault.kind == FaultKind::kCableBreak || fault.kind == FaultKind::kSlaveOff ||
                      fault.kind == FaultKind::kAdapterOff;
    const bool long_after = machine_.shape == SoakShape::kTree && goes;
    fault.until = std::min(fault.until, start + length_ - (long_after ? 12 : 1) * kSecond);
    if (kind.switched_on_anew) {
      network_.sim.faults.push_back({.kind = FaultKind::kSlaveOff,
                                     .slave = fault.slave,
                                     .at = fault.at - kSecond / 2,
                                     .until = fault.at + kSecond / 2});
    }
    if (kind.of_cycles) {
      fault.until = fault.at + fault.count * network_.project.master.cycle_time;
      if (random_.next() % 4 == 0) fault.kind = FaultKind::kHoldAnswers;
    }
    network_.sim.faults.push_back(fault);
    auto& thrown = segments_.back().thrown;
    if (!thrown.empty()) thrown.back().next = fault.at;
    thrown.push_back({fault, &kind});
  }

  /// Good news are told by the same events.
  static bool is_bad(const Event& event) {
    return !event.is<events::SlavesInSync>() && !event.is<events::SlavesNotMonitored>() &&
           !event.is<events::MasterInSync>();
  }

  void drain(RunRecorder& recorder, SampleStore& store, std::vector<Event>& events, Snapshot& snapshot) {
    auto& channels = service_->channels();
    const bool news = channels.snapshot.read(snapshot);
    samples_.clear();
    channels.samples.pop(samples_);
    recorder.add(samples_);
    store.append(samples_);
    auto drained = channels.events.drain();
    for (const auto& event : drained) store.append(event);
    if (news) recorder.add(snapshot);
    if (news) store.append(snapshot);
    for (auto& event : drained) {
      recorder.add(event);
      events.push_back(std::move(event));
    }
  }

  void run_segment(std::size_t segment) {
    const auto start = begin_ + start_of(segment), end = start + length_ - 2 * kSecond;
    network_.project.master.dc.dcm.mode = mode_of(segment);
    const auto config = network_.compiled();
    clock_.advance_to(start + 2 * kSecond);
    RunRecorder recorder(config);
    const auto limits = limits_of(config);
    SampleStore store({.slaves = config.slaves.size(),
                       .cycle_time = limits.cycle_time,
                       .cycle_capacity = static_cast<std::size_t>(length_ / limits.cycle_time),
                       .sync0 = sync0_slaves(config),
                       .sync_grid = sync_grid(config).value_or(0)});
    std::vector<Event> events;
    Snapshot snapshot;
    service_->channels().commands.push(GoOnlineCommand{config, AlState::kOp});
    while (clock_.now() < end) {
      const auto before = clock_.now();
      service_->run_for(std::min<Nanoseconds>(100 * kMillisecond, end - clock_.now()));
      if (clock_.now() == before) clock_.advance_to(before + 100 * kMillisecond);
      drain(recorder, store, events, snapshot);
    }
    const auto report = recorder.finish(snapshot);
    service_->channels().commands.push(GoOfflineCommand{});
    service_->run_for(kSecond / 2);
    (void)service_->channels().events.drain();
    service_->channels().samples.pop(samples_);  // the next run's recorder shall not take them for its own
    look_at_report(segment, report, events);
    look_at_plots(segment, store, limits);
  }

  /// From where the machine is up: what is thrown in before shows in the bring-up, which is judged by its events.
  void look_at_plots(std::size_t number, const SampleStore& store, const RunLimits& limits) {
    auto& segment = segments_[number];
    const auto from = begin_ + start_of(number) + bring_up(mode_of(number));
    for (auto& one : segment.thrown) {
      const auto& kind = *one.kind;
      const auto slave = static_cast<std::size_t>(one.fault.slave);
      const auto until = begin_ + one.fault.until;
      const bool has_gaps =
          std::ranges::any_of(kind.gaps, [&](Signal signal) { return has_gap(store, signal, slave, from, until); });
      one.shown = (kind.shows.empty() && kind.gaps.empty()) || has_gaps || is_small(one) || one.down;
    }
    for (const auto& signal : shown_out_of_order(store, limits, from)) {
      segment.log += "plots: " + text_of(signal) + "\n";
      // A stamp that is off shows in the filtered error for as long as it is no loss of synchronisation.
      bool follows = signal.signal == Signal::kDcmErrorFiltered && !network_.sim.host_jitter.stamp_error.empty();
      follows = follows || is_left_alone(segment, signal.slave, code::kMissedUnlocked);
      for (auto& one : segment.thrown) {
        const bool shows = one.concerns(signal.slave) && holds(one.kind->shows, signal.signal);
        one.shown = one.shown || shows;
        follows = follows || shows || holds(one.kind->may_show, signal.signal);
      }
      if (!follows) segment.strange.push_back(text_of(signal));
    }
  }

  /// In front of the clock that leads, which was away: nobody led it meanwhile, and that is told.
  [[nodiscard]] bool is_left_alone(const Segment& segment, int slave, std::string_view told) const {
    if (machine_.shape != SoakShape::kTree || slave < 0 || slave >= static_cast<int>(machine_.reference)) return false;
    const bool away = std::ranges::any_of(segment.thrown, [](const Thrown& one) {
      return one.fault.kind == FaultKind::kCableBreak || one.fault.kind == FaultKind::kSlaveOff ||
             one.fault.kind == FaultKind::kAdapterOff;
    });
    return away && (told == code::kMissedUnlocked || told == code::kSlaveFellByMisses);
  }

  /// What a clock is slewed by need not leave a wider window, nor one of slaves that are told the time more often. In
  /// DCX it is the external clock's distance that shows it, which is no signal.
  [[nodiscard]] bool is_small(const Thrown& one) const {
    constexpr std::uint8_t kUsualWindow = SyncWindowSettings{}.exponent;
    const auto& master = network_.project.master;
    const bool wide = machine_.shape == SoakShape::kTree || master.dc.sync_window.exponent > kUsualWindow ||
                      master.cycle_time < kMillisecond || master.dc.dcm.mode == DcmMode::kDcx;
    return one.kind->kind == FaultKind::kClockSlew && wide;
  }

  /// Whether the last one's victim was still in OP when it came.
  void note_down(Segment& segment, const std::vector<Event>& events) const {
    auto& last = segment.thrown.back();
    if (segment.thrown.size() < 2 || last.fault.slave < 0) return;
    for (const auto& event : events) {
      const auto* change = event.as<events::StateChanged>();
      if (change == nullptr || event.slave != last.fault.slave || event.time >= begin_ + last.fault.at) continue;
      last.down = change->to != AlState::kOp;
    }
  }

  void log_misses(Segment& segment, const RunReport& report, Nanoseconds start) const {
    const auto seconds = [&](Nanoseconds time) { return static_cast<double>(time - begin_ - start) / 1e9; };
    for (std::size_t slave = 0; slave < report.history.slaves.size(); ++slave) {
      for (const auto& spell : report.history.slaves[slave].missed.list()) {
        segment.log += fmt::format("slave {} missed {} SM2 events between {:.3f} and {:.3f} s\n", slave, spell.count,
                                   seconds(spell.from), seconds(spell.to));
      }
    }
  }

  void look_at_report(std::size_t number, const RunReport& report, const std::vector<Event>& events) {
    auto& segment = segments_[number];
    note_down(segment, events);
    for (auto& one : segment.thrown) one.told = one.kind->harmless || is_small(one) || one.down;
    for (const auto& event : events) {
      segment.log += cli::event_text(event, begin_ + start_of(number)) + "\n";
      for (auto& one : segment.thrown) {
        // Of what is lost it is the time of sending.
        const bool is_then = event.time >= begin_ + one.fault.at - network_.project.master.cycle_time &&
                             event.time < (one.next == INT64_MAX ? INT64_MAX : begin_ + one.next);
        one.told |= holds(one.kind->events, event.kind()) && is_then && is_bad(event) && one.concerns(event.slave);
      }
    }
    log_misses(segment, report, start_of(number));
    for (const auto& finding : diagnose(report)) {
      const auto words = fmt::format("{} {}: {}", finding.code, finding.place.slave, describe(finding));
      segment.log += words + "\n";
      // Who fell and was led up again, by what the other fault brought with it.
      const bool is_explained = (finding.code == code::kSlaveHadFallen || finding.code == code::kSlaveFell) &&
                                std::ranges::find(finding.figures, "why", &Figure::name) != finding.figures.end();
      bool follows = finding.severity == Severity::kNote || is_explained ||
                     is_left_alone(segment, finding.place.slave, finding.code);
      for (auto& one : segment.thrown) {
        const bool its_kind = holds(one.kind->findings, finding.code) && one.concerns(finding.place.slave);
        const bool tells = its_kind && (one.next == INT64_MAX || finding.from < begin_ + one.next);
        one.told |= tells;
        follows = follows || its_kind || holds(one.kind->also, finding.code);
      }
      if (!follows) segment.accused.push_back(words);
    }
  }

  void count(const Segment& segment) {
    for (const auto& one : segment.thrown) {
      auto& count = counts_[one.kind->name];
      ++count.faults;
      count.told += one.told ? 1 : 0;
      count.accused += segment.accused.empty() ? 0 : 1;
      count.shown += one.shown ? 1 : 0;
      count.strange += segment.strange.empty() ? 0 : 1;
    }
  }

  void show(std::size_t number) const {
    const auto& segment = segments_[number];
    for (const auto& [fault, kind, told, shown, next, down] : segment.thrown) {
      fmt::print("{} fault {} ({}, slave {}, at {:.3f} s, value {} ns, count {}){}\n", segment.kept() ? "-" : "MISSED",
                 number, kind->name, fault.slave, static_cast<double>(fault.at - start_of(number)) / 1e9,
                 fault.value_ns, fault.count,
                 !told   ? ": not told"
                 : shown ? ""
                         : ": not in the plots");
    }
    for (const auto& words : segment.accused) fmt::print("  accused: {}\n", words);
    for (const auto& signal : segment.strange) fmt::print("  in the plots, too: {}\n", signal);
    fmt::print("{}\n", segment.log);
    std::fflush(stdout);
  }

  int report(double at_first, double most) const {
    Count all;
    for (const auto& [name, count] : counts_) {
      fmt::print("{:24} {:4} faults {:4} told {:4} with a false finding {:4} in the plots {:4} with something else\n",
                 name, count.faults, count.told, count.accused, count.shown, count.strange);
      all.faults += count.faults;
      all.told += count.told;
      all.accused += count.accused;
      all.shown += count.shown;
      all.strange += count.strange;
    }
    const double hours = static_cast<double>(clock_.now() - begin_) / 3.6e12;
    const bool flat = most - at_first <= 4.0;
    fmt::print(
        "{:.1f} virtual hours, {} faults: {} told, {} with a false finding, {} in the plots, {} with something else "
        "there; {:.1f} MB at first, {:.1f} MB at most\n",
        hours, all.faults, all.told, all.accused, all.shown, all.strange, at_first, most);
    return all.told == all.faults && all.shown == all.faults && all.accused == 0 && all.strange == 0 && flat ? 0 : 1;
  }

  struct Count {
    int faults = 0, told = 0, accused = 0, shown = 0, strange = 0;
  };
  Random random_;
  VirtualClock clock_;
  SoakMachine machine_;
  std::vector<const SoakFaultKind*> kinds_;
  test::SimulatedNetwork& network_ = machine_.network;
  std::vector<Segment> segments_;
  Nanoseconds length_, begin_ = 0;
  std::unique_ptr<MasterService> service_;
  std::vector<CycleSample> samples_;
  std::map<std::string, Count> counts_;
};

}  // namespace
}  // namespace syncline::bench

int main(int argc, char** argv) {
  const double hours = argc > 1 ? std::atof(argv[1]) : 24;
  const int faults = argc > 2 ? std::atoi(argv[2]) : 200;
  const auto seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  const std::string_view which = argc > 4 ? argv[4] : "line";
  using syncline::bench::Way;
  const auto way = which == "line"    ? std::optional(Way::kLine)
                   : which == "drawn" ? std::optional(Way::kDrawn)
                   : which == "pairs" ? std::optional(Way::kPairs)
                   : which == "tree"  ? std::optional(Way::kTree)
                                      : std::nullopt;
  if (!way || hours * 3'600 / std::max(faults, 1) < 60) {
    fmt::print(
        stderr,
        "usage: soak_faults [HOURS [FAULTS [SEED [line|drawn|pairs|tree [loud]]]]], a minute or more for each fault\n");
    return 2;
  }
  return syncline::bench::Soak(hours, faults, seed, *way).run(argc > 5);
}
