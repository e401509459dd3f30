// SPDX-License-Identifier: Apache-2.0
#include "settings/field.h"
#include "settings/limits.h"
#include "settings/not_in_eni.h"
#include "settings/predicates.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

constexpr auto dcm = [](auto& project) -> auto& { return project.master.dc.dcm; };

Choice modes() {
  Choice choice;
  constexpr std::pair<DcmMode, const char*> kModes[] = {
      {DcmMode::kOff, "Off"},
      {DcmMode::kBusShift, "Bus shift"},
      {DcmMode::kMasterShift, "Master shift"},
      {DcmMode::kMasterRefClock, "Master reference clock"},
      {DcmMode::kLinkLayerRefClock, "Adapter reference clock"},
      {DcmMode::kDcx, "External clock (DCX)"},
      {DcmMode::kMasterShiftByApp, "Master shift by application"},
  };
  for (const auto& [mode, text] : kModes) {
    choice.options.push_back({static_cast<std::int64_t>(mode), std::string(dcm_mode_name(mode)), text});
  }
  return choice;
}

Setting set_value_row() {
  auto row = field_setting(
      "master.dc.set_value_us", microseconds(0, limits::kLongestCycle),
      {.label = "Send to SYNC0",
       .help =
           "Distance from sending the cyclic frame to SYNC0; auto is two thirds of the cycle, and later on long buses.",
       .object = "nCtlSetVal",
       .no_eni = not_in_eni::kControl},
      [](auto& p, const Place&) -> auto& { return dcm(p).set_value; });
  row.automatic = [](const Project& project, const Place&) {
    return Value{effective_set_value({}, project.master.cycle_time)};
  };
  row.works = [](const Project& project, const Place&) { return set_values(project.master.cycle_time); };
  return row;
}

std::vector<Setting> control_rows() {
  return {
      field_setting(
          "master.dc.mode", modes(),
          {.label = "Master synchronisation",
           .help = "How the send time of the frames and the reference clock are brought together.",
           .object = "0x0910",
           .eni = "Cyclic/Frame/Cmd (0x0910)"},
          [](auto& p, const Place&) -> auto& { return dcm(p).mode; }),
      set_value_row(),
      field_setting(
          "master.dc.gain_ppt", integer(0, DcmSettings::kMaxGain, "ppt"),
          {.label = "Gain",
           .help = "Share of the control error that one cycle corrects while in sync (nCtlGain), in thousandths; "
                   "0 is 2.",
           .object = "nCtlGain",
           .no_eni = not_in_eni::kControl,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return dcm(p).gain_ppt; }),
      field_setting(
          "master.dc.drift_error_gain", integer(0, DcmSettings::kMaxDriftErrorGain),
          {.label = "Drift error gain",
           .help = "Multiplies the integral gain (nCtlDriftErrorGain): more follows a changing drift faster and "
                   "lets more noise through; 0 is 3.",
           .object = "nCtlDriftErrorGain",
           .no_eni = not_in_eni::kControl,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return dcm(p).drift_error_gain; }),
      field_setting(
          "master.dc.max_valid_ns", integer(0, kSecond, "ns"),
          {.label = "Valid readings",
           .help = "Readings further than this from what is expected are invalid (nMaxValidVal); 0 is 3000 ns.",
           .object = "nMaxValidVal",
           .no_eni = not_in_eni::kControl,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return dcm(p).max_valid_value; }),
  };
}

std::vector<Setting> judgement_rows() {
  return {
      field_setting(
          "master.dc.in_sync_limit_ns", integer(0, kSecond, "ns"),
          {.label = "In-sync limit",
           .help = "Largest control error that still counts as in sync; 0 is 4000 ns.",
           .object = "dwInSyncLimit",
           .no_eni = not_in_eni::kJudged},
          [](auto& p, const Place&) -> auto& { return dcm(p).in_sync_limit; }),
      field_setting(
          "master.dc.in_sync_settle_ms", integer(0, limits::kLongestSettleMs, "ms"),
          {.label = "Settle time of the controller",
           .help = "Time inside that limit before the controller counts as in sync; 0 is 1500 ms.",
           .object = "dwInSyncSettleTime",
           .no_eni = not_in_eni::kJudged},
          [](auto& p, const Place&) -> auto& { return dcm(p).in_sync_settle_time_ms; }),
      field_setting(
          "master.dc.start_delay_ms", integer(0, limits::kLongestTimeoutMs, "ms"),
          {.label = "Start delay",
           .help = "Wait before the control error is judged.",
           .object = "dwInSyncStartDelayCycle",
           .no_eni = not_in_eni::kJudged,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return dcm(p).start_delay_ms; }),
      field_setting(
          "master.dc.control_off", Switch{},
          {.label = "Control off",
           .help = "Nothing is moved, so that the natural drift and the adjustment that would be made can be read "
                   "(bCtlOff).",
           .object = "bCtlOff",
           .no_eni = not_in_eni::kControl,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return dcm(p).control_off; }),
      field_setting(
          "master.dc.standard_loop_values", Switch{},
          {.label = "Standard loop values",
           .help = "Leaves the time control loops of the slaves (0x0930, 0x0934) at the values of their reset.",
           .object = "0x0930, 0x0934",
           .eni = "Master/InitCmds",
           .expert = true},
          [](auto& p, const Place&) -> auto& { return dcm(p).standard_loop_values; }),
      field_setting(
          "master.dc.log", Switch{},
          {.label = "Controller log",
           .help = "Keeps the log of the controller, one line a cycle (bLogEnabled).",
           .object = "bLogEnabled",
           .no_eni = not_in_eni::kControl,
           .expert = true},
          [](auto& p, const Place&) -> auto& { return dcm(p).log; }),
  };
}

}  // namespace

std::vector<Setting> dcm_rows() {
  auto rows = control_rows();
  append(rows, judgement_rows());
  return rows;
}

}  // namespace syncline::settings
