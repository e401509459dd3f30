// SPDX-License-Identifier: Apache-2.0
#include "families/family_problems.h"

#include <fmt/format.h>

#include <algorithm>

#include "config/object_description.h"
#include "config/slave_config.h"
#include "families/device_family.h"
#include "findings/eni_devices_words.h"
#include "findings/sentence.h"
#include "protocol/assign_activate.h"
#include "reasons/because.h"

namespace syncline::families {
namespace {

using Topic = Problem::Topic;

constexpr std::uint16_t kSync0Type = 2, kSync1Type = 3;
constexpr std::uint16_t kAxisStep = 0x0800;  // CiA 402: objects of the next axis of one device
constexpr unsigned kMostAxes = 8;
constexpr std::uint32_t kDriveProfile = 402;

/// Modes of any CiA 402 drive whose targets mean nothing without a fixed distance from the frame.
constexpr ModeNeedsDc kAnyDrive[] = {
    {8, false,
     "Cyclic synchronous position mode needs SYNC0: without it targets come at no fixed distance from the servo "
     "period"},
    {9, false,
     "Cyclic synchronous velocity mode needs SYNC0: without it targets come at no fixed distance from the servo "
     "period"},
    {10, false,
     "Cyclic synchronous torque mode needs SYNC0: without it targets come at no fixed distance from the servo period"},
};

/// Nearest cycles that the family takes below and above: "750 us or 875 us".
std::string nearest(const CycleLimits& limits, Nanoseconds cycle) {
  const Nanoseconds step = limits.full_step;
  const Nanoseconds least = std::max((limits.shortest + step - 1) / step * step, step);
  const Nanoseconds most = limits.longest > 0 ? limits.longest / step * step : INT64_MAX / 2;
  const Nanoseconds below = std::min(cycle / step * step, most), above = cycle / step * step + step;
  std::string text;
  if (below >= least) text = microseconds(below);
  if (above <= most && below != most)
    text += fmt::format("{}{}", text.empty() ? "" : " or ", microseconds(std::max(above, least)));
  return text;
}

enum class CycleVerdict : std::uint8_t { kFits, kTooShort, kTooLong, kOffStep, kPartly };
CycleVerdict cycle_verdict(const CycleLimits& limits, Nanoseconds cycle) {
  if (limits.shortest > 0 && cycle < limits.shortest) return CycleVerdict::kTooShort;
  if (limits.longest > 0 && cycle > limits.longest) return CycleVerdict::kTooLong;
  if (cycle % limits.step != 0) return CycleVerdict::kOffStep;
  return cycle % limits.full_step != 0 ? CycleVerdict::kPartly : CycleVerdict::kFits;
}

class SlaveProblems {
 public:
  SlaveProblems(const Family* family, const SlaveConfig& slave, Nanoseconds bus_cycle)
      : slave_(slave),
        bus_cycle_(bus_cycle),
        family_(family),
        sync0_(slave.dc && AssignActivate{slave.dc->assign_activate}.sync0()) {}

  std::vector<Problem> take() {
    if (family_ != nullptr) {
      check_cycle();
      check_objects();
      check_error_limit();
      check_sync_types();
      check_can_cycle();
    }
    check_modes();
    return std::move(out_);
  }

 private:
  struct Written {
    std::uint64_t value = 0;
    std::size_t command = 0;
  };

  /// The last start-up command that writes the object.
  [[nodiscard]] std::optional<Written> written(coe::ObjectAddress object) const {
    if (!slave_.mailbox) return std::nullopt;
    const auto& commands = slave_.mailbox->coe_commands;
    for (std::size_t i = commands.size(); i-- > 0;) {
      const StartupCommand& command = commands[i].command;
      const bool writes = command.enabled && !command.complete_access && command.index == object.index &&
                          command.sub_index == object.sub_index && !command.data.empty() && command.data.size() <= 8;
      if (!writes) continue;
      Written found{0, i};
      for (std::size_t k = command.data.size(); k-- > 0;) found.value = found.value << 8 | command.data[k];
      return found;
    }
    return std::nullopt;
  }

  /// What a finder knows besides the words.
  struct About {
    Topic topic{};
    bool refused = false;
    std::optional<std::size_t> command{};
    bool outputs = false;
  };
  template <FigureName... kNames>
  void add(const About& about, std::type_identity_t<FindingSentence<words::kEniDevices, kNames...>> code,
           Named<kNames>... figures) {
    out_.push_back({about.topic, about.refused, about.outputs, about.command,
                    make_finding<words::kEniDevices, kNames...>(code, {}, std::move(figures)...)});
  }
  [[nodiscard]] Named<"family"> family() const { return fig::text<"family">(std::string(family_->name)); }
  [[nodiscard]] Named<"devices"> devices() const { return fig::phrase<"devices">(family_->devices); }

  void check_cycle() {
    if (!sync0_ || !family_->cycle || slave_.dc->cycle_time0 <= 0) return;
    const Nanoseconds cycle = slave_.dc->cycle_time0;
    const CycleLimits& limits = *family_->cycle;
    const auto better = nearest(limits, cycle);
    const auto comes = fig::time<"cycle">(cycle);
    const auto next = better.empty() ? fig::phrase<"nearest">("none") : fig::text<"nearest">(better);
    switch (cycle_verdict(limits, cycle)) {
      case CycleVerdict::kFits:
        return;
      case CycleVerdict::kTooShort:
        return add({Topic::kCycleRefused, true}, "ENI-DEV-01/shortest", comes, fig::time<"limit">(limits.shortest),
                   family(), devices(), next);
      case CycleVerdict::kTooLong:
        return add({Topic::kCycleRefused, true}, "ENI-DEV-01/longest", comes, fig::time<"limit">(limits.longest),
                   family(), devices(), next);
      case CycleVerdict::kOffStep:
        return add({Topic::kCycleRefused, true}, "ENI-DEV-01", comes, family(), devices(),
                   fig::time<"step">(limits.step), next);
      case CycleVerdict::kPartly:
        return add({Topic::kCyclePartly, false}, "ENI-DEV-02", comes, family(), devices(),
                   fig::time<"step">(limits.full_step), fig::phrase<"otherwise">(limits.otherwise), next);
    }
  }

  void check_objects() {
    const unsigned most = family_->objects.per_direction;
    if (most == 0) return;
    for (const PdoDirection direction : {PdoDirection::kRx, PdoDirection::kTx}) {
      std::size_t objects = 0;
      for (const ConfiguredPdo& configured : slave_.pdos) {
        if (configured.direction != direction || !configured.pdo.sync_manager) continue;
        objects += static_cast<std::size_t>(
            std::ranges::count_if(configured.pdo.entries, [](const PdoEntry& entry) { return entry.index != 0; }));
      }
      if (objects <= most) continue;
      add({Topic::kObjects, true, {}, direction == PdoDirection::kRx}, "ENI-DEV-03", fig::count<"objects">(objects),
          family(), devices(), fig::count<"most">(most));
    }
  }

  void check_error_limit() {
    const auto limit = written(kSyncErrorLimit);
    if (!limit || !family_->error_limit) return;
    if (limit->value > family_->error_limit->largest) {
      add({Topic::kErrorLimit, true, limit->command}, "ENI-DEV-04", fig::count<"limit">(limit->value), family(),
          devices(), fig::count<"most">(family_->error_limit->largest));
    } else if (limit->value == 0) {
      add({Topic::kErrorLimitOff, false, limit->command}, "ENI-DEV-05");
    }
  }

  void check_sync_type(std::uint16_t index, std::span<const std::uint16_t> taken, std::uint16_t usual) {
    const bool outputs = index == kOutputSync;
    const SyncTypes& types = family_->sync_types;
    const auto type = written({index, 1});
    const auto about = [&](bool refused) {
      return About{Topic::kSyncType, refused, type ? std::optional(type->command) : std::nullopt, outputs};
    };
    const auto object = fig::hex16<"object">(index);
    if (type && !types.writable) return add(about(true), "ENI-DEV-07/read-only", object, family(), devices());
    if (type && std::ranges::find(taken, type->value) == taken.end()) {
      return add(about(true), "ENI-DEV-07", object, fig::number<"type">(type->value), family(), devices());
    }
    const std::uint64_t value = type ? type->value : usual;
    const bool by_signal = value == kSync0Type || value == kSync1Type;
    if (type && by_signal && !sync0_) {
      types.follow_dc ? add(about(false), "ENI-DEV-08/off", object) : add(about(true), "ENI-DEV-07/off", object);
    } else if (sync0_ && !by_signal && !types.follow_dc) {
      add(about(false), "ENI-DEV-08", object, fig::number<"type">(value),
          fig::phrase<"consequence">(outputs ? "outputs count from their arrival" : "inputs are not those of SYNC0"));
    }
  }

  void check_sync_types() {
    const SyncTypes& types = family_->sync_types;
    if (types.outputs.empty() || !slave_.mailbox || !slave_.mailbox->coe) return;
    check_sync_type(kOutputSync, types.outputs, types.usual_outputs);
    check_sync_type(kInputSync, types.inputs, types.usual_inputs);
  }

  void check_can_cycle() {
    if (!family_->gateway) return;
    const CanGateway& gateway = *family_->gateway;
    const auto can = written(gateway.can_cycle), told = written(gateway.told_cycle);
    if (told && static_cast<std::int64_t>(told->value) != bus_cycle_ && told->value != 0) {
      const auto given = fig::time<"told">(static_cast<Nanoseconds>(told->value));
      const auto cycle = fig::time<"cycle">(bus_cycle_);
      sync0_ ? add({Topic::kCanCycle, true, told->command}, "ENI-DEV-09/told", given, cycle)
             : add({Topic::kCanCycle, false, told->command}, "ENI-DEV-10/told", given, cycle);
    }
    if (!can || can->value == 0) return;
    const auto cycle = static_cast<Nanoseconds>(std::min<std::uint64_t>(can->value, UINT32_MAX));
    const Nanoseconds bus = sync0_ && slave_.dc->cycle_time0 > 0 ? slave_.dc->cycle_time0 : bus_cycle_;
    if (bus > 0 && cycle % bus != 0) {
      add({Topic::kCanCycle, true, can->command}, "ENI-DEV-09", fig::time<"can">(cycle),
          fig::text<"object">(fmt::format("0x{:04X}:{:02X}", gateway.can_cycle.index, gateway.can_cycle.sub_index)),
          fig::time<"cycle">(bus));
    } else if (!sync0_ && cycle != bus && (!told || told->value == 0)) {
      add({Topic::kCanCycle, false, can->command}, "ENI-DEV-10");
    }
  }

  [[nodiscard]] std::span<const ModeNeedsDc> modes() const {
    if (family_ != nullptr && !family_->modes_need_dc.list.empty()) return family_->modes_need_dc.list;
    const bool drive =
        slave_.mailbox && std::ranges::any_of(slave_.mailbox->profiles, [](const ChannelProfile& profile) {
          return (profile.profile_no & 0xFFFF) == kDriveProfile;
        });
    return drive ? std::span<const ModeNeedsDc>(kAnyDrive) : std::span<const ModeNeedsDc>{};
  }

  void check_modes() {
    const auto needing = modes();
    if (sync0_ || needing.empty()) return;
    for (unsigned axis = 0; axis < kMostAxes; ++axis) {
      const auto index = static_cast<std::uint16_t>(kModeOfOperation.index + axis * kAxisStep);
      const auto mode = written({index, 0});
      if (!mode) continue;
      const auto need = std::ranges::find(needing, static_cast<std::int8_t>(mode->value), &ModeNeedsDc::mode);
      if (need == needing.end()) continue;
      add({Topic::kModeNeedsDc, false, mode->command}, "ENI-DEV-06", fig::hex16<"object">(index),
          fig::number<"mode">(need->mode), fig::phrase<"reason">(need->why));
    }
  }

  const SlaveConfig& slave_;
  Nanoseconds bus_cycle_;
  const Family* family_;
  bool sync0_;
  std::vector<Problem> out_;
};

}  // namespace

std::string microseconds(Nanoseconds time) { return fmt::format("{:g} us", static_cast<double>(time) / 1e3); }

CycleJudgement judge_cycle(const Family& family, Nanoseconds sync0_cycle) {
  if (!family.cycle) return {};
  const CycleLimits& limits = *family.cycle;
  const auto devices = Reason::phrase(family.devices);
  switch (cycle_verdict(limits, sync0_cycle)) {
    case CycleVerdict::kFits:
      return {};
    case CycleVerdict::kTooShort:
      return {true, because("{limit} is the shortest cycle that {family} {devices} take", microseconds(limits.shortest),
                            family.name, devices)};
    case CycleVerdict::kTooLong:
      return {true, because("{limit} is the longest cycle that {family} {devices} take", microseconds(limits.longest),
                            family.name, devices)};
    case CycleVerdict::kOffStep:
      return {true,
              because("{family} {devices} take multiples of {step}", family.name, devices, microseconds(limits.step))};
    case CycleVerdict::kPartly:
      return {false, because("{family} {devices} need multiples of {step}; {otherwise}", family.name, devices,
                             microseconds(limits.full_step), Reason::phrase(limits.otherwise))};
  }
  return {};
}

std::vector<Problem> problems(const Family* family, const SlaveConfig& slave, Nanoseconds bus_cycle) {
  return SlaveProblems(family, slave, bus_cycle).take();
}

}  // namespace syncline::families
