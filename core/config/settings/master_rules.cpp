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
constexpr auto loop = [](auto& project) -> auto& { return project.master.dc.loop; };
constexpr auto notifications = [](auto& project) -> auto& { return project.master.dc.notifications; };
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
      field_rule(
          "master.real_time.spin_us",
          "Most of each wait that is spent asking the clock: earlier wake-ups for processor time. Used is what this "
          "host needs for 99 of 100 frames to leave at most 2 % of the cycle late, and at most a quarter of the cycle.",
          MicrosecondCodec{0, kMillisecond}, [](auto& p, const Place&) -> auto& { return real_time(p).spin; }),
      field_rule(
          "master.real_time.cpu", "Processor that the cyclic thread is bound to; auto leaves it to the system.",
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
                 "Measures the propagation delays again every 30 s and corrects them in small steps.", SwitchCodec{},
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
      field_rule("master.dc.burst_ends_early", "The burst ends when all slaves have settled.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return dc(p).burst_ends_early; }),
      field_rule("master.dc.start_time_safety_us", "Lead of the SYNC start time (0x0990) on the time of writing it.",
                 MicrosecondCodec{0, 10 * kSecond}, [](auto& p, const Place&) -> auto& { return dc(p).start_time_safety; }),
      field_rule("master.dc.start_time_grid_us", "Start times are multiples of this; 0 is the bus cycle.",
                 MicrosecondCodec{0, kSecond}, [](auto& p, const Place&) -> auto& { return dc(p).start_time_grid; }),
  };
}

std::vector<Rule> dc_choice_rules() {
  return {
      field_rule("master.dc.first_slave_is_reference_clock",
                 "The first slave on the bus that has a system time leads, whatever is configured.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return dc(p).first_slave_is_reference_clock; }),
      field_rule("master.dc.all_slaves",
                 "Every slave that has a system time is synchronised, with or without a DC operation mode.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return dc(p).all_slaves; }),
      field_rule("master.dc.delay_rounds", "Latches of the receive times (0x0900) whose medians give the propagation delays.",
                 IntegerCodec<std::uint8_t>{1, 100}, [](auto& p, const Place&) -> auto& { return dc(p).delay_rounds; }),
      field_rule("master.dc.delay_difference_ns",
                 "Processing minus forwarding latency of the ESCs (tDiff of their data sheets); auto is 40 ns.",
                 AutoCodec<IntegerCodec<std::uint32_t>>{{0, 1000, "ns"}},
                 [](auto& p, const Place&) -> auto& { return dc(p).delay_difference; }),
      field_rule("master.dc.loop.speed_counter_start",
                 "Start value of the slaves' time control loops (0x0930): small ones follow faster, large ones smoother; "
                 "auto suits the cycle.",
                 AutoCodec<IntegerCodec<std::uint16_t>>{{0x0080, 0x3FFF}},
                 [](auto& p, const Place&) -> auto& { return loop(p).speed_counter_start; }),
      field_rule("master.dc.loop.filter_depth_difference",
                 "Exponent of the average over the time differences (0x0934); auto is 0.",
                 AutoCodec<IntegerCodec<std::uint8_t>>{{0, 15}},
                 [](auto& p, const Place&) -> auto& { return loop(p).filter_depth_difference; }),
      field_rule("master.dc.loop.filter_depth_speed_counter",
                 "Exponent of the average over the clock period deviation (0x0935); auto is 8.",
                 AutoCodec<IntegerCodec<std::uint8_t>>{{0, 15}},
                 [](auto& p, const Place&) -> auto& { return loop(p).filter_depth_speed_counter; }),
  };
}

std::vector<Rule> dc_notification_rules() {
  return {
      field_rule("master.dc.notify.reference_clock", "Tells presence and loss of the reference clock.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return notifications(p).reference_clock; }),
      field_rule("master.dc.notify.slaves_in_sync", "Tells when the slaves come in sync and fall out of it.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return notifications(p).slaves_in_sync; }),
      field_rule("master.dc.notify.dc_status", "Tells that the distributed clocks are initialised, or why not.",
                 SwitchCodec{}, [](auto& p, const Place&) -> auto& { return notifications(p).dc_status; }),
      field_rule("master.dc.notify.dcm_in_sync", "Tells when the master comes in sync and falls out of it.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return notifications(p).dcm_in_sync; }),
  };
}

std::vector<Rule> dcm_rules() {
  return {
      field_rule("master.dc.mode", "How the send time of the frames and the reference clock are brought together.",
                 DcmModeCodec{}, [](auto& p, const Place&) -> auto& { return dcm(p).mode; }),
      field_rule("master.dc.set_value_us", "Distance from sending the cyclic frame to SYNC0; auto is two thirds of the cycle.",
                 AutoCodec<MicrosecondCodec>{{0, kLongestCycle}},
                 [](auto& p, const Place&) -> auto& { return dcm(p).set_value; }),
      field_rule("master.dc.gain_ppt",
                 "Share of the control error that one cycle corrects while in sync (nCtlGain), in thousandths; 0 is 2.",
                 IntegerCodec<std::uint32_t>{0, DcmSettings::kMaxGain, "ppt"},
                 [](auto& p, const Place&) -> auto& { return dcm(p).gain_ppt; }),
      field_rule("master.dc.drift_error_gain",
                 "Multiplies the integral gain (nCtlDriftErrorGain): more follows a changing drift faster and lets more "
                 "noise through; 0 is 3.",
                 IntegerCodec<std::uint32_t>{0, DcmSettings::kMaxDriftErrorGain},
                 [](auto& p, const Place&) -> auto& { return dcm(p).drift_error_gain; }),
      field_rule("master.dc.max_valid_ns",
                 "Readings further than this from what is expected are invalid (nMaxValidVal); 0 is 3000 ns.",
                 IntegerCodec<Nanoseconds>{0, kSecond, "ns"},
                 [](auto& p, const Place&) -> auto& { return dcm(p).max_valid_value; }),
      field_rule("master.dc.in_sync_limit_ns", "Largest control error that still counts as in sync; 0 is 4000 ns.",
                 IntegerCodec<Nanoseconds>{0, kSecond, "ns"},
                 [](auto& p, const Place&) -> auto& { return dcm(p).in_sync_limit; }),
      field_rule("master.dc.in_sync_settle_ms",
                 "Time inside that limit before the controller counts as in sync; 0 is 1500 ms.",
                 IntegerCodec<std::uint32_t>{0, 60'000, "ms"},
                 [](auto& p, const Place&) -> auto& { return dcm(p).in_sync_settle_time_ms; }),
      field_rule("master.dc.start_delay_ms", "Wait before the control error is judged.",
                 IntegerCodec<std::uint32_t>{0, 600'000, "ms"},
                 [](auto& p, const Place&) -> auto& { return dcm(p).start_delay_ms; }),
      field_rule("master.dc.control_off",
                 "Nothing is moved, so that the natural drift and the adjustment that would be made can be read (bCtlOff).",
                 SwitchCodec{}, [](auto& p, const Place&) -> auto& { return dcm(p).control_off; }),
      field_rule("master.dc.standard_loop_values",
                 "Leaves the time control loops of the slaves (0x0930, 0x0934) at the values of their reset.", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return dcm(p).standard_loop_values; }),
      field_rule("master.dc.log", "Keeps the log of the controller, one line a cycle (bLogEnabled).", SwitchCodec{},
                 [](auto& p, const Place&) -> auto& { return dcm(p).log; }),
  };
}

}  // namespace

std::vector<Rule> master_rules() {
  auto rules = general_rules();
  for (auto more : {recovery_rules(), real_time_rules(), dc_rules(), dc_choice_rules(), dc_notification_rules(),
                    dcm_rules()}) {
    rules.insert(rules.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  }
  return rules;
}

}  // namespace syncline::settings
