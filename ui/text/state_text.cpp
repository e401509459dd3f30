// SPDX-License-Identifier: Apache-2.0
#include "ui/text/state_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "protocol/al_state.h"
#include "trace/counted_at_least.h"
#include "ui/text/glossary.h"
#include "ui/text/signal_text.h"
#include "ui/text/sync_text.h"

namespace syncline::ui {
namespace {

constexpr int kStateBits = 0x0F;

StateText alState(int status) {
  const auto state = static_cast<AlState>(status & kStateBits);
  if ((status & kAlErrorFlag) != 0) return {theme::Tone::kBad, stateName(state) + QStringLiteral(" + ERR")};
  return {theme::stateTone(state), stateName(state)};
}

/// The counts that may be higher than they say: "Port 0, PDI watchdog".
StateText countsAtLeast(int bits) {
  QStringList names;
  for (const auto signal : counts_in(static_cast<std::uint32_t>(bits))) {
    const auto port = static_cast<int>(signal) - static_cast<int>(Signal::kPortErrors);
    const bool of_port = port >= 0 && port < static_cast<int>(kPorts * kPortSignals);
    names += of_port ? QCoreApplication::translate("Signals", "Port %1").arg(port / static_cast<int>(kPortSignals))
                     : signalName(signal);
  }
  return {theme::Tone::kWarning, names.join(QStringLiteral(", "))};
}

}  // namespace

StateText stateText(Signal signal, int value) {
  if (signal == Signal::kCountsAtLeast) return countsAtLeast(value);
  if (signal != Signal::kSlavesSync && signal != Signal::kMasterSync) return alState(value);
  const auto state = static_cast<SyncState>(value);
  return {syncTone(state), syncStateText(state)};
}

}  // namespace syncline::ui
