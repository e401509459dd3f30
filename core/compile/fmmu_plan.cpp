// SPDX-License-Identifier: Apache-2.0
#include "compile/fmmu_plan.h"

#include "compile/process_image.h"
#include "compile/slave_plan.h"
#include "protocol/fmmu.h"
#include "protocol/registers.h"

namespace syncline::compiler {
namespace {

/// `bits` bits from bit `offset` behind the placement's start.
Fmmu process_data_fmmu(const Placement& at, std::uint32_t offset, std::uint32_t bits,
                       const ProcessDataChannel& channel) {
  const std::uint32_t first = at.start_bit + offset;
  const std::uint32_t last = first + bits - 1;
  Fmmu fmmu;
  fmmu.logical_start = at.logical_address + first / 8;
  fmmu.length = static_cast<std::uint16_t>(last / 8 - first / 8 + 1);
  fmmu.logical_start_bit = static_cast<std::uint8_t>(first % 8);
  fmmu.logical_stop_bit = static_cast<std::uint8_t>(last % 8);
  fmmu.physical_start = channel.description.start_address;
  fmmu.write = channel.is_output();
  fmmu.read = !channel.is_output();
  fmmu.active = true;
  return fmmu;
}

/// A SyncManager whose data begin where those of the one before it end, in the ESC and in the process image.
bool continues(const Fmmu& before, const Fmmu& next) {
  return before.logical_stop_bit == 7 && next.logical_start_bit == 0 &&
         next.logical_start == before.logical_start + before.length &&
         next.physical_start == before.physical_start + before.length;
}

/// Several digital terminals have more SyncManagers of a byte each than FMMUs: one FMMU maps neighbours together.
void join_neighbours(std::vector<FmmuPlan>& fmmus) {
  std::vector<FmmuPlan> joined;
  for (const FmmuPlan& fmmu : fmmus) {
    const bool joins = !joined.empty() && joined.back().use == fmmu.use && continues(joined.back().image, fmmu.image);
    if (!joins) {
      joined.push_back(fmmu);
      continue;
    }
    Fmmu& before = joined.back().image;
    before.length = static_cast<std::uint16_t>(before.length + fmmu.image.length);
    before.logical_stop_bit = fmmu.image.logical_stop_bit;
  }
  fmmus = std::move(joined);
}

void add_direction(std::vector<FmmuPlan>& fmmus, const SlavePlan& slave, bool outputs) {
  const Placement& at = outputs ? slave.outputs : slave.inputs;
  std::uint32_t offset = 0;
  for (const auto& channel : slave.channels) {
    if (channel.is_output() != outputs || channel.bit_length == 0) {
      continue;
    }
    const std::uint32_t bits = slave.bit_oriented ? channel.bit_length : channel.byte_length() * 8U;
    fmmus.push_back({outputs ? FmmuUse::kOutputs : FmmuUse::kInputs, process_data_fmmu(at, offset, bits, channel)});
    offset += bits;
  }
}

/// Maps the "buffer written" bit (0x0805.0 of SM 0) of the input mailbox to the slave's bit of the mailbox-state area.
Fmmu mailbox_state_fmmu(const MailboxPlan& mailbox) {
  constexpr std::uint16_t kStatusByte = 5;  // of a SyncManager
  Fmmu fmmu;
  fmmu.logical_start = kMailboxStateLogicalBase + mailbox.status_bit / 8;
  fmmu.length = 1;
  fmmu.logical_start_bit = fmmu.logical_stop_bit = static_cast<std::uint8_t>(mailbox.status_bit % 8);
  fmmu.physical_start = static_cast<std::uint16_t>(reg::sync_manager(mailbox.in_number) + kStatusByte);
  fmmu.read = true;
  fmmu.active = true;
  return fmmu;
}

}  // namespace

std::vector<FmmuPlan> plan_fmmus(const SlavePlan& slave) {
  std::vector<FmmuPlan> fmmus;
  add_direction(fmmus, slave, true);
  add_direction(fmmus, slave, false);
  if (!slave.device().fmmus.empty() && fmmus.size() > slave.device().fmmus.size()) join_neighbours(fmmus);
  if (slave.mailbox && slave.mailbox->uses_status_bit) {
    fmmus.push_back({FmmuUse::kMailboxState, mailbox_state_fmmu(*slave.mailbox)});
  }
  return fmmus;
}

}  // namespace syncline::compiler
