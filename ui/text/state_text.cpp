// SPDX-License-Identifier: Apache-2.0
#include "ui/text/state_text.h"

#include "protocol/al_state.h"
#include "ui/text/glossary.h"
#include "ui/text/sync_text.h"

namespace syncline::ui {
namespace {

constexpr int kStateBits = 0x0F;

StateText alState(int status) {
  const auto state = static_cast<AlState>(status & kStateBits);
  if ((status & kAlErrorFlag) != 0) return {theme::Tone::kBad, stateName(state) + QStringLiteral(" + ERR")};
  return {theme::stateTone(state), stateName(state)};
}

}  // namespace

StateText stateText(Signal signal, int value) {
  if (signal != Signal::kSlavesSync && signal != Signal::kMasterSync) return alState(value);
  const auto state = static_cast<SyncState>(value);
  return {syncTone(state), syncStateText(state)};
}

}  // namespace syncline::ui
