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
#include "tests/support/holding_link.h"
#include "tests/support/simulated_network.h"
#include "trace/run_report.h"

namespace syncline::test {

struct AwaySpan {
  Nanoseconds from = 0, to = 0;  // since the start
};

/// An adapter that is switched off for some spans of time.
class AwayLink final : public Link {
 public:
  AwayLink(std::unique_ptr<Link> inner, Clock& clock, std::vector<AwaySpan> spans)
      : inner_(std::move(inner)), clock_(clock), spans_(std::move(spans)), begin_(clock.now()) {}
  Status send(std::span<const std::uint8_t> frame) override {
    if (away()) return fail(ErrorCode::kLinkDown, "test");
    return inner_->send(frame);
  }
  Result<Nanoseconds> send_corrected(std::span<const std::uint8_t> frame, const SendTimeField& field) override {
    if (away()) return fail(ErrorCode::kLinkDown, "test");
    return inner_->send_corrected(frame, field);
  }
  [[nodiscard]] std::optional<Nanoseconds> sent_at() const override { return inner_->sent_at(); }
  Result<ReceivedFrame> receive(std::span<std::uint8_t> buffer, Nanoseconds deadline) override {
    if (away()) return fail(ErrorCode::kLinkDown, "test");
    if (in_card_) {
      std::ranges::copy(bytes_, buffer.begin());
      return *std::exchange(in_card_, std::nullopt);
    }
    auto received = inner_->receive(buffer, deadline);
    if (!received || received->length == 0 || !away()) return received;
    // It has come while the adapter went away, and is read when that is back.
    bytes_.assign(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(received->length));
    in_card_ = *received;
    return fail(ErrorCode::kLinkDown, "test");
  }
  [[nodiscard]] LinkDescription describe() const override { return inner_->describe(); }

 private:
  [[nodiscard]] bool away() const {
    const auto now = clock_.now() - begin_;
    return std::ranges::any_of(spans_, [now](const AwaySpan& span) { return now >= span.from && now < span.to; });
  }
  std::unique_ptr<Link> inner_;
  Clock& clock_;
  std::vector<AwaySpan> spans_;
  Nanoseconds begin_;
  std::optional<ReceivedFrame> in_card_{};
  std::vector<std::uint8_t> bytes_{};
};

/// Loses the frames on their way to the bus of which a function says so.
class LosingLink final : public Link {
 public:
  using Loses = std::function<bool(std::span<const std::uint8_t> frame)>;
  LosingLink(std::unique_ptr<Link> inner, Loses loses) : inner_(std::move(inner)), loses_(std::move(loses)) {}
  Status send(std::span<const std::uint8_t> frame) override {
    return loses_ && loses_(frame) ? Status{} : inner_->send(frame);
  }
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
  std::vector<AwaySpan> adapter_away;
  std::vector<HeldSpan> held_up;
  LosingLink::Loses loses;
  std::function<void(NetworkConfig&)> change;  // of what was compiled, before it is run

  FaultConfig& fault(FaultKind kind, Nanoseconds at, int slave = -1) {
    FaultConfig fault;
    fault.kind = kind;
    fault.at = at;
    fault.slave = slave;
    return network.sim.faults.emplace_back(fault);
  }
  void run(Nanoseconds duration) {
    VirtualClock clock;
    clock.set_wakeup_jitter(jitter, 1);
    auto config = network.compiled();
    if (change) change(config);
    RunRecorder recorder(config);
    auto sent = std::make_unique<LosingLink>(network.link(clock), loses);
    auto way = std::make_unique<HoldingLink>(std::move(sent), clock, held_up);
    MasterService service(std::make_unique<AwayLink>(std::move(way), clock, adapter_away), clock);
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
