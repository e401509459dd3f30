// SPDX-License-Identifier: Apache-2.0
#include "settings/predicates.h"

#include "config/slave_settings.h"
#include "families/device_family.h"
#include "families/families.h"
#include "settings/setting_type.h"

#include <algorithm>
#include <utility>

#include "settings/limits.h"

namespace syncline::settings {
namespace {

bool is_multiple(Nanoseconds value, Nanoseconds of, Nanoseconds rounding) {
  const auto rest = value % of;
  return value >= of - rounding && std::min(rest, of - rest) < rounding;
}

}  // namespace

Range set_values(Nanoseconds cycle) { return {1, cycle - 1}; }

bool keeps_step(Nanoseconds sync_period, Nanoseconds cycle, Nanoseconds rounding) {
  if (sync_period <= 0 || cycle <= 0) return false;
  return is_multiple(sync_period, cycle, rounding) || is_multiple(cycle, sync_period, rounding);
}

bool within_period(Nanoseconds shift, Nanoseconds sync_period) { return shift < sync_period && shift > -sync_period; }

bool is_sync_time(Nanoseconds time) { return time >= -limits::kLargestSyncTime && time <= limits::kLargestSyncTime; }

bool has_clock(const SlaveSettings& slave) { return slave.device.dc.has_value(); }
bool has_mailbox(const SlaveSettings& slave) { return slave.device.mailbox.has_value(); }
bool has_coe(const SlaveSettings& slave) { return has_mailbox(slave) && slave.device.mailbox->coe; }
bool has_soe(const SlaveSettings& slave) { return has_mailbox(slave) && slave.device.mailbox->soe; }
bool has_eoe(const SlaveSettings& slave) { return has_mailbox(slave) && slave.device.mailbox->eoe; }
bool has_aoe(const SlaveSettings& slave) { return has_mailbox(slave) && slave.device.mailbox->aoe; }
bool is_gateway(const SlaveSettings& slave) {
  const auto* family = families::find(slave.device);
  return family != nullptr && family->gateway;
}
bool has_process_data(const SlaveSettings& slave) {
  return !slave.device.rx_pdos.empty() || !slave.device.tx_pdos.empty() || !slave.modules.empty();
}

bool is_position(std::size_t slaves, std::int64_t position) { return position >= 0 && std::cmp_less(position, slaves); }

}  // namespace syncline::settings
