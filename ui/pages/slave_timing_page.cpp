// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_timing_page.h"

#include "ui/editors/field_binder.h"
#include "ui/widgets/card.h"

namespace syncline::ui {

SlaveTimingPage::SlaveTimingPage(Workspace& workspace) : Page(workspace, "slaveTimingPage", tr("Watchdogs (Expert)")) {
  auto* columns = new CardColumns;
  fields().setExpertPage();
  fields().keys(*columns->add(0, tr("Watchdogs")), {"slave.N.watchdog.divider", "slave.N.watchdog.process_data",
                                                    "slave.N.watchdog.pdi", "slave.N.watchdog.outputs"});
  fields().keys(*columns->add(1, tr("Time-outs of State Changes")),
                {"slave.N.timeout.preop_ms", "slave.N.timeout.safeop_op_ms", "slave.N.timeout.back_to_init_ms",
                 "slave.N.timeout.back_to_safeop_ms"});
  columns->addStretch();
  setWidget(columns);
}

bool SlaveTimingPage::appliesTo(int slave) const { return slave >= 0 && fields().wanted(slave); }

void SlaveTimingPage::refresh() { fields().refresh(); }

}  // namespace syncline::ui
