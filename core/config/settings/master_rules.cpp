// SPDX-License-Identifier: Apache-2.0
#include "config/settings/codecs.h"

namespace syncline::settings {
namespace {

constexpr Nanoseconds kShortestCycle = 31'250, kLongestCycle = 100 * kMillisecond;

/// References to the same field of a const and of a mutable project.
constexpr auto master = [](auto& project) -> auto& { return project.master; };
constexpr auto dc = [](auto& project) -> auto& { return project.master.dc; };
constexpr auto dcm = [](auto& project) -> auto& { return project.master.dc.dcm; };
constexpr auto recovery = [](auto& project) -> auto& { return project.master.recovery; };
constexpr auto real_time = [](auto& project) -> auto& { return project.master.real_time; };
constexpr auto window = [](auto& project) -> auto& { return project.master.dc.sync_window; };

Rule reference_clock_rule() {
  const AutoCodec<IntegerCodec<std::uint16_t>> codec;
  auto rule = field_rule("master.dc.reference_clock",
                         "Position of the slave whose clock all others follow; auto is the first slave with DC.", codec,
                         [](auto& p, const Place&) -> auto& { return dc(p).reference_clock; });
  rule.type = "slave position";
  rule.range = "auto, 0..last slave";
  const auto apply = rule.set;
  rule.set = [codec, apply](Project& project, const Place& place, std::string_view text) -> Status {
    const auto position = codec.parse(text);
    if (position && *position && **position >= project.slaves.size()) {
      return bad_value(fmt::format("there is no slave at position {}; the project has {}", **position, project.slaves.size()));
    }
    return apply(project, place, text);
  };
  return rule;
}

std::vector<Rule> general_rules() {
  return {
      field_rule("master.name", "Name of the master in the ENI file.", NameCodec{},
                 [](auto& p, const Place&) -> auto& { return master(p).name; }),
      field_rule("master.cycle_time_us", "Time between two cyclic frames.", MicrosecondCodec{kShortestCycle, kLongestCycle},
                 [](auto& p, const Place&) -> auto& { return master(p).cycle_time; }),
      field_rule("master.destination_mac", "Destination address of the frames; broadcast unless a switch demands another.",
                 MacCodec{}, [](auto& p, const Place&) -> auto& { return master(p).destination_mac; }),
      field_rule("master.overlap_process_data",
                 "Inputs and outputs of a slave share logical addresses, which halves the cyclic frame.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return master(p).overlap_process_data; }),
      field_rule("master.source_mac", "Source address in the ENI file; zeros leave it to the network card.", MacCodec{},
                 [](auto& p, const Place&) -> auto& { return master(p).source_mac; }),
  };
}

std::vector<Rule> recovery_rules() {
  return {
      field_rule("master.recovery.automatic",
                 "Slaves that come back (cable healed, power back) are set up again and led to the state of the bus.",
                 SwitchCodec{}, [](auto& p, const Place&) -> auto& { return recovery(p).automatic; }),
      field_rule("master.recovery.error_tries",
                 "How often an error state is acknowledged and the state requested again; 0 leaves it to the user.",
                 IntegerCodec<std::uint32_t>{0, 1000}, [](auto& p, const Place&) -> auto& { return recovery(p).error_tries; }),
      field_rule("master.recovery.start_incomplete",
                 "Goes online with the slaves that are there; the others join when they appear.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return recovery(p).start_incomplete; }),
  };
}

std::vector<Rule> real_time_rules() {
  return {
      field_rule("master.real_time.spin_us",
                 "The last part of each wait is spent asking the clock: earlier wake-ups for processor time. At most a "
                 "quarter of the cycle is used.",
                 MicrosecondCodec{0, kMillisecond}, [](auto& p, const Place&) -> auto& { return real_time(p).spin; }),
      field_rule("master.real_time.cpu", "Processor that the cyclic thread is bound to; auto leaves it to the system.",
                 AutoCodec<IntegerCodec<std::uint16_t>>{{0, 1023}},
                 [](auto& p, const Place&) -> auto& { return real_time(p).cpu; }),
  };
}

std::vector<Rule> dc_rules() {
  return {
      field_rule("master.dc.enabled", "Distributed clocks for the whole bus.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return dc(p).enabled; }),
      reference_clock_rule(),
      field_rule("master.dc.continuous_propagation_compensation",
                 "Kept for other masters' sake; Syncline's own master measures the delays at start-up only.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return dc(p).continuous_propagation_compensation; }),
      field_rule("master.dc.show_64bit_system_time", "Reads and shows 64 bits of the system time (0x0910).", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return dc(p).show_64bit_system_time; }),
      field_rule("master.dc.sync_window", "Watches the wire-ored system time difference of all slaves (0x092C).",
                 SwitchCodec{}, [](auto& p, const Place&) -> auto& { return window(p).enabled; }),
      field_rule("master.dc.sync_window_exponent", "Limit of the sync window: 2^exponent - 1 ns.",
                 IntegerCodec<std::uint8_t>{1, 30}, [](auto& p, const Place&) -> auto& { return window(p).exponent; }),
      field_rule("master.dc.sync_window_settle_ms", "Time inside the window before the bus counts as in sync.",
                 IntegerCodec<std::uint32_t>{0, 60'000, "ms"},
                 [](auto& p, const Place&) -> auto& { return window(p).settle_time_ms; }),
      field_rule("master.dc.burst_total", "Frames of the first drift compensation (FRMW or ARMW of 0x0910).",
                 IntegerCodec<std::uint32_t>{0, 1'000'000, "frames"},
                 [](auto& p, const Place&) -> auto& { return dc(p).burst_total; }),
      field_rule("master.dc.burst_bulk", "Frames of that burst in one cycle.", IntegerCodec<std::uint32_t>{1, 1000, "frames"},
                 [](auto& p, const Place&) -> auto& { return dc(p).burst_bulk; }),
      field_rule("master.dc.start_time_safety_us", "Lead of the SYNC start time (0x0990) on the time of writing it.",
                 MicrosecondCodec{0, 10 * kSecond}, [](auto& p, const Place&) -> auto& { return dc(p).start_time_safety; }),
      field_rule("master.dc.start_time_grid_us", "Start times are multiples of this; 0 is the bus cycle.",
                 MicrosecondCodec{0, kSecond}, [](auto& p, const Place&) -> auto& { return dc(p).start_time_grid; }),
  };
}

std::vector<Rule> dcm_rules() {
  return {
      field_rule("master.dc.mode", "How the send time of the frames and the reference clock are brought together.",
                 DcmModeCodec{}, [](auto& p, const Place&) -> auto& { return dcm(p).mode; }),
      field_rule("master.dc.set_value_us", "Distance from sending the cyclic frame to SYNC0; auto is two thirds of the cycle.",
                 AutoCodec<MicrosecondCodec>{{0, kLongestCycle}},
                 [](auto& p, const Place&) -> auto& { return dcm(p).set_value; }),
      field_rule("master.dc.in_sync_limit_ns", "Largest control error that still counts as in sync.",
                 IntegerCodec<Nanoseconds>{1, kSecond, "ns"},
                 [](auto& p, const Place&) -> auto& { return dcm(p).in_sync_limit; }),
      field_rule("master.dc.in_sync_settle_ms", "Time inside that limit before the controller counts as in sync.",
                 IntegerCodec<std::uint32_t>{0, 60'000, "ms"},
                 [](auto& p, const Place&) -> auto& { return dcm(p).in_sync_settle_time_ms; }),
      field_rule("master.dc.start_delay_ms", "Wait before the controller starts.",
                 IntegerCodec<std::uint32_t>{0, 600'000, "ms"},
                 [](auto& p, const Place&) -> auto& { return dcm(p).start_delay_ms; }),
  };
}

}  // namespace

std::vector<Rule> master_rules() {
  auto rules = general_rules();
  for (auto more : {recovery_rules(), real_time_rules(), dc_rules(), dcm_rules()}) {
    rules.insert(rules.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return rules;
}

}  // namespace syncline::settings
