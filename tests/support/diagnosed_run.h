// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "channels/command.h"
#include "channels/cycle_sample.h"
#include "channels/event.h"
#include "channels/master_channels.h"
#include "diagnosis/run_diagnosis.h"
#include "findings/run_codes.h"
#include "master/master_service.h"
#include "tests/support/simulated_network.h"
#include "trace/run_report.h"

namespace syncline::test {

/// Loses the frames on their way to the bus of which a function says so.
class LosingLink final : public Link {
 public:
  using Loses = std::function<bool(std::span<const std::uint8_t> frame)>;
  LosingLink(std::unique_ptr<Link> inner, Loses loses) : inner_(std::move(inner)), loses_(std::move(loses)) {}
  Status send(std::span<const std::uint8_t> frame) override { return loses_(frame) ? Status{} : inner_->send(frame); }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    return inner_->receive(buffer, deadline);
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  std::unique_ptr<Link> inner_;
  Loses loses_;
};

/// A simulated machine with something known wrong with it, run on the virtual clock, and what is found.
class DiagnosedRun {
 public:
  SimulatedNetwork network;
  JitterProfile jitter;
  RunReport report;
  std::vector<Finding> findings;
  std::vector<Event> events;
  std::map<std::size_t, std::uint32_t> shown_misses;  // the last that the samples said, by position
  LosingLink::Loses loses;
  std::function<void(NetworkConfig&)> change;  // of what was compiled, before it is run

  FaultConfig& fault(FaultKind kind, Nanoseconds at, int slave = -1) {
    FaultConfig fault;
    fault.kind = kind;
    fault.at = at;
    fault.slave = slave;
    return network.sim.faults.emplace_back(fault);
  }
  void adapter_off(Nanoseconds from, Nanoseconds to) { fault(FaultKind::kAdapterOff, from).until = to; }
  void hold_frames(Nanoseconds from, Nanoseconds to, Nanoseconds longer, bool coming_back = false) {
    auto& held = fault(coming_back ? FaultKind::kHoldAnswers : FaultKind::kHoldFrames, from);
    held.until = to;
    held.value_ns = longer;
  }
  void run(Nanoseconds duration) {
    VirtualClock clock;
    clock.set_wakeup_jitter(jitter, 1);
    auto config = network.compiled();
    if (change) change(config);
    RunRecorder recorder(config);
    auto link = network.link(clock);
    if (loses) link = std::make_unique<LosingLink>(std::move(link), loses);
    MasterService service(std::move(link), clock);
    auto& channels = service.channels();
    channels.commands.push(GoOnlineCommand{config, AlState::kOp});
    std::vector<CycleSample> samples;
    Snapshot snapshot;
    for (const auto end = clock.now() + duration; clock.now() < end;) {
      service.run_for(std::min<Nanoseconds>(100 * kMillisecond, end - clock.now()));
      const bool news = channels.snapshot.read(snapshot);
      samples.clear();
      channels.samples.pop(samples);
      recorder.add(samples);
      for (const auto& sample : samples) {
        if (sample.sm2_position >= 0)
          shown_misses[static_cast<std::size_t>(sample.sm2_position)] = sample.slave_sm2_missed;
      }
      if (news) recorder.add(snapshot);
      for (auto& event : channels.events.drain()) {
        recorder.add(event);
        events.push_back(std::move(event));
      }
    }
    report = recorder.finish(snapshot);
    findings = diagnose(report);
  }
  [[nodiscard]] bool found(std::string_view code, int slave = -1) const {
    return std::ranges::any_of(
        findings, [&](const Finding& f) { return f.code == code && (slave < 0 || f.place.slave == slave); });
  }
  [[nodiscard]] bool accuses() const {
    return std::ranges::any_of(findings, [](const Finding& f) { return f.severity != Severity::kNote; });
  }
  /// All that is said, for a test's message.
  [[nodiscard]] std::string said() const {
    std::string text;
    for (const auto& finding : findings) text += std::string(finding.code) + ": " + describe(finding) + "\n";
    return text;
  }
};

}  // namespace syncline::test
