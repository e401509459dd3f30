// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "settings/field.h"
#include "settings/limits.h"
#include "settings/not_in_eni.h"
#include "settings/predicates.h"
#include "settings/tables.h"

namespace syncline::settings {
namespace {

template <class T>
Value known(const std::optional<T>& of_device) {
  return to_value(of_device);
}

Choice revision_rules() {
  Choice choice;
  for (const auto rule : {RevisionCheck::kNone, RevisionCheck::kEqual, RevisionCheck::kEqualOrGreater,
                          RevisionCheck::kLowWordEqual, RevisionCheck::kLowWordEqualHighWordEqualOrGreater}) {
    choice.options.push_back({static_cast<std::int64_t>(rule), std::string(revision_check_name(rule)), {}});
  }
  return choice;
}

std::vector<Setting> identity_rows() {
  return {
      slave_setting(
          "optional", Switch{},
          {.label = "Optional",
           .help = "The slave may be missing; it is known by its device ID or alias, and the others run without it.",
           .eni = "Slave/HotConnect"},
          [](auto& slave) -> auto& { return slave.optional; }),
      with_automatic(
          slave_setting(
              "check.revision_rule", revision_rules(),
              {.label = "Revision rule",
               .help = "How check.revision compares (ETG.2000 CheckRevisionNo): LW and HW are the low and "
                       "high words, G is newer; auto as in the ESI.",
               .object = "SII 0x000C",
               .eni = "InitCmd/Validate",
               .expert = true},
              [](auto& slave) -> auto& { return slave.check.revision_rule; }),
          [](const Project& p, const Place& place) { return known(at_slave(p, place).device.check_revision); }),
      slave_setting(
          "check.alias", Switch{},
          {.label = "Alias",
           .help = "Compares the alias in the slave (0x0012) with the configured one at start-up.",
           .object = "0x0012",
           .eni = "InitCmd/Validate"},
          [](auto& slave) -> auto& { return slave.check.alias; }),
      with_unset(slave_setting(
                     "check.device_id", integer(0, limits::kLargestWord),
                     {.label = "Device ID",
                      .help = "Explicit device ID (switches or display of the device, ETG.1020) that is compared at "
                              "start-up.",
                      .object = "0x0134",
                      .eni = "InitCmd/Validate"},
                     [](auto& slave) -> auto& { return slave.check.device_id; }),
                 "none"),
  };
}

Setting watchdog_row(const char* name, const char* label, const char* help, const char* address,
                     std::optional<std::uint16_t> WatchdogSettings::*field,
                     std::optional<std::uint16_t> DeviceDescription::*of_device) {
  return with_automatic(
      slave_setting(
          fmt::format("watchdog.{}", name), integer(0, limits::kLargestWord),
          {.label = label, .help = help, .object = address, .eni = "Slave/InitCmds", .expert = true},
          [field](auto& slave) -> auto& { return slave.watchdog.*field; }),
      [of_device](const Project& p, const Place& place) { return known(at_slave(p, place).device.*of_device); });
}

std::vector<Setting> watchdog_rows() {
  return {
      watchdog_row("divider", "Watchdog divider",
                   "Watchdog divider (0x0400): unit of the watchdogs is (value + 2) * 40 ns; auto as in the ESI.",
                   "0x0400", &WatchdogSettings::divider, &DeviceDescription::reg_0400),
      watchdog_row("pdi", "PDI watchdog",
                   "PDI watchdog (0x0410) in units of the divider; 0 switches it off; auto as in the ESI.", "0x0410",
                   &WatchdogSettings::pdi, &DeviceDescription::reg_0410),
      watchdog_row("process_data", "Process data watchdog",
                   "Process data watchdog (0x0420) in units of the divider; 0 switches it off; auto as in the ESI.",
                   "0x0420", &WatchdogSettings::process_data, &DeviceDescription::reg_0420),
      slave_setting(
          "watchdog.outputs", Switch{},
          {.label = "Outputs trigger the watchdog",
           .help = "Outputs trigger the process data watchdog (control byte of their SyncManagers, bit 6); auto as "
                   "in the ESI.",
           .object = "0x0804",
           .eni = "ProcessData/Sm2",
           .expert = true},
          [](auto& slave) -> auto& { return slave.watchdog.outputs; }),
  };
}

template <class Automatic>
Setting timeout_row(const char* name, const char* label, const char* what, const char* eni,
                    std::optional<std::uint32_t> TimeoutSettings::*field, Automatic automatic) {
  return with_automatic(slave_setting(
                            fmt::format("timeout.{}_ms", name), integer(1, limits::kLongestTimeoutMs, "ms"),
                            {.label = label,
                             .help = fmt::format("Time-out for {}; auto as in the ESI.", what),
                             .eni = eni,
                             .no_eni = *eni == '\0' ? not_in_eni::kMaster : "",
                             .expert = true},
                            [field](auto& slave) -> auto& { return slave.timeouts.*field; }),
                        automatic);
}

std::vector<Setting> timeout_rows() {
  const auto state = [](std::uint32_t StateTimeouts::*of_device) {
    return [of_device](const Project& p, const Place& place) {
      return to_value(at_slave(p, place).device.timeouts.*of_device);
    };
  };
  const auto mailbox = [](std::uint32_t MailboxDescription::*of_device) {
    return [of_device](const Project& p, const Place& place) {
      const auto& described = at_slave(p, place).device.mailbox;
      return described ? to_value((*described).*of_device) : Value{};
    };
  };
  constexpr auto kState = "InitCmd/Timeout", kNowhere = "";
  std::vector<Setting> rows{
      timeout_row("preop", "INIT to PREOP", "INIT to PREOP or BOOT", kState, &TimeoutSettings::preop,
                  state(&StateTimeouts::preop)),
      timeout_row("safeop_op", "PREOP to SAFEOP to OP", "PREOP to SAFEOP and SAFEOP to OP", kState,
                  &TimeoutSettings::safeop_op, state(&StateTimeouts::safeop_op)),
      timeout_row("back_to_init", "Back to INIT", "the way back to INIT", kState, &TimeoutSettings::back_to_init,
                  state(&StateTimeouts::back_to_init)),
      timeout_row("back_to_safeop", "Back to SAFEOP", "OP to SAFEOP", kState, &TimeoutSettings::back_to_safeop,
                  state(&StateTimeouts::back_to_safeop)),
  };
  append(rows,
         for_devices(
             {
                 timeout_row("mailbox_request", "Mailbox request", "the slave to take a mailbox request", kNowhere,
                             &TimeoutSettings::mailbox_request, mailbox(&MailboxDescription::request_timeout_ms)),
                 timeout_row("mailbox_response", "Mailbox response", "the slave to answer a mailbox request", kNowhere,
                             &TimeoutSettings::mailbox_response, mailbox(&MailboxDescription::response_timeout_ms)),
             },
             has_mailbox));
  return rows;
}

}  // namespace

std::vector<Setting> slave_option_rows() {
  auto rows = identity_rows();
  append(rows, watchdog_rows());
  append(rows, timeout_rows());
  return rows;
}

}  // namespace syncline::settings
