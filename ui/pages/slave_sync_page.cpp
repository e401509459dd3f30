// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_sync_page.h"

#include <algorithm>

#include "settings/predicates.h"
#include "ui/editors/field_binder.h"
#include "ui/pages/sync_settings_editor.h"
#include "ui/widgets/card.h"

namespace syncline::ui {

SlaveSyncPage::SlaveSyncPage(Workspace& workspace) : Page(workspace, "slaveSyncPage", tr("Synchronisation")) {
  auto* columns = new CardColumns;
  sync_ = new SyncSettingsEditor(*columns->add(0, tr("Device Cycle")), *this);
  fields().keys(*columns->add(1, tr("CAN")), {"slave.N.can.cycle_us", "slave.N.can.tx_delay_percent"});
  fields().items(*columns->add(1, tr("Output Pins")), "slave.N.output_pin.K",
                 [](const Project&, const settings::Place& place) { return tr("Pin %1").arg(place.item); });
  columns->addStretch();
  setWidget(columns);
}

bool SlaveSyncPage::appliesTo(int slave) const { return slave >= 0 && fields().wanted(slave); }

void SlaveSyncPage::refresh() {
  const auto at = static_cast<std::size_t>(std::max(node(), 0));
  if (node() < 0 || at >= project().slaves.size()) return;
  const auto& slave = project().slaves[at];
  sync_->showSlave(slave);
  fields().refresh();
}

}  // namespace syncline::ui
