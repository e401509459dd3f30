// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_mailbox_page.h"

#include "ui/editors/field_binder.h"
#include "ui/widgets/card.h"

namespace syncline::ui {

SlaveMailboxPage::SlaveMailboxPage(Workspace& workspace) : Page(workspace, "slaveMailboxPage", tr("Mailbox")) {
  auto* columns = new CardColumns;
  fields().keys(*columns->add(0, tr("Ethernet (EoE)")),
                {"slave.N.eoe.enabled", "slave.N.eoe.mac", "slave.N.eoe.ip", "slave.N.eoe.subnet",
                 "slave.N.eoe.gateway", "slave.N.eoe.dns", "slave.N.eoe.host_name"});
  fields().keys(*columns->add(1, tr("ADS (AoE)")), {"slave.N.aoe.net_id"});
  fields().keys(
      *columns->add(1, tr("Mailbox")),
      {"slave.N.mailbox.out_size", "slave.N.mailbox.in_size", "slave.N.mailbox.state_bit",
       "slave.N.mailbox.poll_time_ms", "slave.N.timeout.mailbox_request_ms", "slave.N.timeout.mailbox_response_ms"});
  columns->addStretch();
  setWidget(columns);
}

bool SlaveMailboxPage::appliesTo(int slave) const { return slave >= 0 && fields().wanted(slave); }

void SlaveMailboxPage::refresh() { fields().refresh(); }

}  // namespace syncline::ui
