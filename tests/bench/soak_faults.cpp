// SPDX-License-Identifier: Apache-2.0
// soak_faults [HOURS [FAULTS [SEED [line|drawn [loud]]]]]: one master on one simulated machine for so many virtual
// hours (24), brought up anew for each of so many faults (200) of every kind at random times. Each must be told by its
// kind and be seen in the plots, nothing else accused or seen there, and the memory stay what it was. The machine is a
// line of six, or one drawn by the seed: a branch with up to twelve more, some without SYNC0 or without a clock, clocks
// of 32 bits, another reference clock, a second task, a branch that may be unplugged, noisy latches, cables whose ways
// differ, another cycle time, limit, mode and host. Exit code 1 when a promise is missed.
#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/cli.h"
#include "app/cli/event_text.h"
#include "bench/soak_fault_kinds.h"
#include "bench/soak_machine.h"
#include "bench/soak_plots.h"
#include "config/sync_grid.h"
#include "link/simulated_host.h"
#include "support/random.h"
#include "tests/support/diagnosed_run.h"

namespace syncline::bench {
namespace {

constexpr Nanoseconds kBringUp = 30 * kSecond;  // long enough for every machine to be in OP and in sync

/// Without what the allocator keeps for later: the store of a segment comes and goes.
double resident_mb() {
  ::malloc_trim(0);
  std::ifstream in("/proc/self/statm");
  std::size_t size = 0, resident = 0;
  in >> size >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

/// What came out of one fault.
struct Outcome {
  bool told = false, shown = true;
  std::vector<std::string> accused, strange;  // beyond what the kind brings with it: findings, signals in the plots
  std::string log;
};

class Soak {
 public:
  Soak(double hours, int faults, std::uint64_t seed, bool drawn)
      : random_(seed),
        machine_(soak_machine(random_, drawn)),
        length_(static_cast<Nanoseconds>(hours * 3.6e12 / faults)) {
    begin_ = clock_.now();
    network_.sim.seed = seed;
    for (int i = 0; i < faults; ++i) add_fault(i);
    const auto host = set_up_host(clock_, network_.sim);
    auto bus = sim::SimBus::create(network_.sim, begin_);
    service_ = std::make_unique<MasterService>(
        bus ? make_simulated_link("sim", std::move(*bus), clock_, host) : nullptr, clock_);
  }

  int run(bool loud) {
    fmt::print("{}\n", text_of(machine_));
    double at_first = 0, most = 0;
    const auto settled = std::min<std::size_t>(20, thrown_in_.size() / 2);
    for (std::size_t i = 0; i < thrown_in_.size(); ++i) {
      const auto outcome = run_segment(i);
      judge(i, outcome, loud);
      const double resident = resident_mb();
      if (i == settled) at_first = resident;
      if (i >= settled) most = std::max(most, resident);
    }
    return report(at_first, most);
  }

 private:
  [[nodiscard]] Nanoseconds start_of(std::size_t segment) const { return static_cast<Nanoseconds>(segment) * length_; }

  void add_fault(int number) {
    const auto kinds = soak_fault_kinds();
    const auto& kind = kinds[static_cast<std::size_t>(number) % kinds.size()];
    const auto start = start_of(static_cast<std::size_t>(number));
    FaultConfig fault;
    fault.kind = kind.kind;
    fault.at = kind.while_down
                   ? start + kSecond
                   : start + kBringUp +
                         static_cast<Nanoseconds>(random_.uniform(0, 0.5) * static_cast<double>(length_ - kBringUp));
    const auto whom = victims(machine_, kind);
    if (!whom.empty()) fault.slave = whom[random_.next() % whom.size()];
    if (kind.longest > 0) {
      fault.until = fault.at + static_cast<Nanoseconds>(random_.uniform(static_cast<double>(kind.shortest),
                                                                        static_cast<double>(kind.longest)));
    }
    if (kind.while_down) fault.until = start + length_ - kSecond;
    fault.count = 1 + static_cast<std::uint32_t>(random_.next() % kind.most_count);
    fault.value_ns =
        static_cast<Nanoseconds>(random_.uniform(static_cast<double>(kind.least), static_cast<double>(kind.most)));
    if (kind.either_sign && random_.next() % 2 == 0) fault.value_ns = -fault.value_ns;
    if (kind.in_cycles) fault.value_ns *= network_.project.master.cycle_time / kMillisecond;
    fault.ppm = kind.ppm;
    fault.port = kind.port;
    fault.state = kind.state;
    fault.code = kind.code;
    fault.period = kind.period;
    fault.until = std::min(fault.until, start + length_ - kSecond);
    if (kind.switched_on_anew) {
      network_.sim.faults.push_back({.kind = FaultKind::kSlaveOff,
                                     .slave = fault.slave,
                                     .at = fault.at - kSecond / 2,
                                     .until = fault.at + kSecond / 2});
    }
    network_.sim.faults.push_back(fault);
    thrown_in_.push_back(fault);
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

  Outcome run_segment(std::size_t segment) {
    const auto start = begin_ + start_of(segment), end = start + length_ - 2 * kSecond;
    network_.project.master.dc.dcm.mode = machine_.modes[segment % machine_.modes.size()];
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
    auto outcome = outcome_of(segment, report, events);
    look_at_plots(segment, store, limits, outcome);
    return outcome;
  }

  /// From where the machine is up: what is thrown in before shows in the bring-up, which is judged by its events.
  void look_at_plots(std::size_t segment, const SampleStore& store, const RunLimits& limits, Outcome& outcome) const {
    const auto& fault = thrown_in_[segment];
    const auto& kind = soak_fault_kinds()[segment % soak_fault_kinds().size()];
    const auto from = begin_ + start_of(segment) + kBringUp;
    outcome.shown = (kind.shows.empty() && kind.gaps.empty()) || std::ranges::any_of(kind.gaps, [&](Signal signal) {
                      return has_gap(store, signal, static_cast<std::size_t>(fault.slave), from);
                    });
    for (const auto& shown : shown_out_of_order(store, limits, from)) {
      outcome.log += "plots: " + text_of(shown) + "\n";
      const bool concerns = fault.slave < 0 || shown.slave < 0 || shown.slave == fault.slave;
      const bool shows = concerns && std::ranges::find(kind.shows, shown.signal) != kind.shows.end();
      // A stamp that is off shows in the filtered error for as long as it is no loss of synchronisation.
      const bool stamped = shown.signal == Signal::kDcmErrorFiltered && !network_.sim.host_jitter.stamp_error.empty();
      const bool follows = stamped || std::ranges::find(kind.may_show, shown.signal) != kind.may_show.end();
      outcome.shown = outcome.shown || shows;
      if (!shows && !follows) outcome.strange.push_back(text_of(shown));
    }
  }

  Outcome outcome_of(std::size_t segment, const RunReport& report, const std::vector<Event>& events) const {
    const auto& fault = thrown_in_[segment];
    const auto kinds = soak_fault_kinds();
    const auto& kind = kinds[segment % kinds.size()];
    Outcome outcome;
    // What a clock is slewed by need not leave a wider window.
    constexpr std::uint8_t kUsualWindow = SyncWindowSettings{}.exponent;
    const bool is_small =
        kind.kind == FaultKind::kClockSlew && network_.project.master.dc.sync_window.exponent > kUsualWindow;
    outcome.told = kind.harmless || is_small;
    const auto concerns = [&](int slave) { return fault.slave < 0 || slave == fault.slave; };
    for (const auto& event : events) {
      outcome.log += cli::event_text(event, begin_ + start_of(segment)) + "\n";
      const bool its_kind = std::ranges::find(kind.events, event.kind()) != kind.events.end();
      // Of what is lost it is the time of sending.
      const bool is_late_enough = event.time >= begin_ + fault.at - network_.project.master.cycle_time;
      outcome.told |= its_kind && is_late_enough && is_bad(event) && (event.slave < 0 || concerns(event.slave));
    }
    for (const auto& finding : diagnose(report)) {
      const auto words = fmt::format("{} {}: {}", finding.code, finding.place.slave, describe(finding));
      outcome.log += words + "\n";
      const bool its_kind = std::ranges::find(kind.findings, finding.code) != kind.findings.end();
      const bool follows = std::ranges::find(kind.also, finding.code) != kind.also.end();
      outcome.told |= its_kind && (finding.place.slave < 0 || concerns(finding.place.slave));
      const bool accuses = finding.severity != Severity::kNote;
      if (accuses && !follows && !(its_kind && (finding.place.slave < 0 || concerns(finding.place.slave))))
        outcome.accused.push_back(words);
    }
    return outcome;
  }

  void judge(std::size_t segment, const Outcome& outcome, bool loud) {
    const auto& fault = thrown_in_[segment];
    const auto& kind = soak_fault_kinds()[segment % soak_fault_kinds().size()];
    auto& count = counts_[kind.name];
    ++count.faults;
    count.told += outcome.told ? 1 : 0;
    count.accused += outcome.accused.empty() ? 0 : 1;
    count.shown += outcome.shown ? 1 : 0;
    count.strange += outcome.strange.empty() ? 0 : 1;
    const bool kept = outcome.told && outcome.shown && outcome.accused.empty() && outcome.strange.empty();
    if (kept && !loud) return;
    fmt::print("{} fault {} ({}, slave {}, at {:.3f} s, value {} ns, count {}){}\n", loud ? "-" : "MISSED", segment,
               kind.name, fault.slave, static_cast<double>(fault.at - start_of(segment)) / 1e9, fault.value_ns,
               fault.count,
               !outcome.told   ? ": not told"
               : outcome.shown ? ""
                               : ": not in the plots");
    for (const auto& words : outcome.accused) fmt::print("  accused: {}\n", words);
    for (const auto& signal : outcome.strange) fmt::print("  in the plots, too: {}\n", signal);
    fmt::print("{}\n", outcome.log);
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
  test::SimulatedNetwork& network_ = machine_.network;
  std::vector<FaultConfig> thrown_in_;  // by segment
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
  if ((which != "line" && which != "drawn") || hours * 3'600 / std::max(faults, 1) < 60) {
    fmt::print(stderr,
               "usage: soak_faults [HOURS [FAULTS [SEED [line|drawn [loud]]]]], a minute or more for each fault\n");
    return 2;
  }
  return syncline::bench::Soak(hours, faults, seed, which == "drawn").run(argc > 5);
}
