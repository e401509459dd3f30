// SPDX-License-Identifier: Apache-2.0
#include "compile/memory_init_cmds.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compile/init_cmd_builder.h"
#include "protocol/registers.h"
#include "protocol/sync_manager.h"

namespace syncline::compiler {
namespace {

template <class Image>
Bytes bytes_of(const Image& image) {
  const auto encoded = image.encode();
  return {encoded.begin(), encoded.end()};
}

SyncManager mailbox_image(const MailboxChannel& channel, std::uint8_t control) {
  return {.start = channel.start,
          .length = channel.length,
          .control = control,
          .status = 0,
          .activate = 1,
          .pdi_control = 0};
}

const char* use_name(FmmuUse use) {
  switch (use) {
    case FmmuUse::kOutputs:
      return "outputs";
    case FmmuUse::kInputs:
      return "inputs";
    case FmmuUse::kMailboxState:
      return "mailbox state";
    case FmmuUse::kUnused:
      break;
  }
  return "unused";
}

}  // namespace

void MemoryCommands::add_mailbox(InitCmdBuilder& cmds) const {
  if (!slave_.mailbox) {
    return;
  }
  using enum Transition;
  const MailboxPlan& mailbox = *slave_.mailbox;
  const std::uint16_t out = reg::sync_manager(mailbox.out_number);
  const std::uint16_t in = reg::sync_manager(mailbox.in_number);
  const std::size_t both = 2 * SyncManager::kSize;
  cmds.fpwr({kIP, kIB, kPI, kSI, kOI}, "clear mailbox SyncManagers", out, Bytes(both));
  cmds.apwr({kBI}, "clear mailbox SyncManagers", out, Bytes(both));
  const Transitions start = mailbox.bootstrap_out ? Transitions{kIP} : Transitions{kIP, kIB};
  const auto set = [&](const Transitions& when, const char* what, std::uint8_t number, std::uint16_t address,
                       const MailboxChannel& channel, std::uint8_t control) {
    cmds.fpwr(when, fmt::format("set SM {} ({})", number, what), address, bytes_of(mailbox_image(channel, control)))
        .answered();
  };
  set(start, "mailbox out", mailbox.out_number, out, mailbox.out, mailbox.out_control);
  set(start, "mailbox in", mailbox.in_number, in, mailbox.in, mailbox.in_control);
  if (mailbox.bootstrap_out) {
    set({kIB}, "bootstrap out", mailbox.out_number, out, *mailbox.bootstrap_out, mailbox.out_control);
    set({kIB}, "bootstrap in", mailbox.in_number, in, *mailbox.bootstrap_in, mailbox.in_control);
  }
}

void MemoryCommands::add_sync_managers(InitCmdBuilder& cmds) const {
  std::vector<ProcessDataChannel> channels;
  std::ranges::remove_copy_if(slave_.channels, std::back_inserter(channels), &ProcessDataChannel::is_virtual);
  if (channels.empty()) {
    return;
  }
  using enum Transition;
  const std::uint8_t first = channels.front().number;
  const std::uint8_t last = channels.back().number;
  const auto length = static_cast<std::uint16_t>((last - first + 1U) * SyncManager::kSize);
  const Transitions leaving{kIP, kSP, kSI, kOP, kOI};
  if (dialect_ == EniDialect::kEcEngineer) {
    cmds.fpwr_zeros(leaving, "clear process data SyncManagers", reg::sync_manager(first), length);
  } else {
    cmds.fpwr(leaving, "clear process data SyncManagers", reg::sync_manager(first), Bytes(length));
  }
  for (const auto& channel : channels) {
    // Such a device must not accept outputs below OP: its SyncManager is open only there.
    if (channel.description.op_only) {
      cmds.fpwr({kOS}, fmt::format("clear SM {} (outputs)", channel.number), reg::sync_manager(channel.number),
                Bytes(SyncManager::kSize));
    }
  }
  for (const auto& channel : channels) {
    cmds.fpwr({channel.description.op_only ? kSO : kPS},
              fmt::format("set SM {} ({})", channel.number, channel.is_output() ? "outputs" : "inputs"),
              reg::sync_manager(channel.number), bytes_of(channel.image()))
        .answered();
  }
}

void MemoryCommands::add_fmmus(InitCmdBuilder& cmds) const {
  using enum Transition;
  for (std::size_t n = 0; n < slave_.fmmus.size(); ++n) {
    const FmmuPlan& fmmu = slave_.fmmus[n];
    // The mailbox state is read in PREOP already.
    const Transitions when = fmmu.use == FmmuUse::kMailboxState ? Transitions{kIP, kIB} : Transitions{kPS};
    cmds.fpwr(when, fmt::format("set FMMU {} ({})", n, use_name(fmmu.use)), reg::fmmu(static_cast<unsigned>(n)),
              bytes_of(fmmu.image))
        .answered();
  }
}

void MemoryCommands::add_clear_fmmus(InitCmdBuilder& cmds) const {
  using enum Transition;
  for (std::size_t n = 0; n < slave_.fmmus.size(); ++n) {
    const bool mailbox_state = slave_.fmmus[n].use == FmmuUse::kMailboxState;
    cmds.fpwr(mailbox_state ? Transitions{kPI, kBI, kSI, kOI} : Transitions{kSP, kSI, kOP, kOI},
              fmt::format("clear FMMU {}", n), reg::fmmu(static_cast<unsigned>(n)), Bytes(Fmmu::kSize));
  }
}

}  // namespace syncline::compiler
