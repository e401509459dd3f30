// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/master_dc_expert_page.h"

#include "ui/editors/field_binder.h"
#include "ui/widgets/card.h"

namespace syncline::ui {

MasterDcExpertPage::MasterDcExpertPage(Workspace& workspace)
    : Page(workspace, "masterDcExpertPage", tr("Distributed Clocks (Expert)")) {
  auto* columns = new CardColumns;
  fields().setExpertPage();
  fields().keys(
      *columns->add(0, tr("Clocks and Delays")),
      {"master.dc.first_slave_is_reference_clock", "master.dc.all_slaves",
       "master.dc.continuous_propagation_compensation", "master.dc.delay_rounds", "master.dc.delay_difference_ns"});
  fields().keys(*columns->add(1, tr("Burst and Start Time")),
                {"master.dc.burst_total", "master.dc.burst_bulk", "master.dc.burst_ends_early",
                 "master.dc.start_time_safety_us", "master.dc.start_time_grid_us", "master.dc.input_shift_us"});
  fields().keys(*columns->add(2, tr("Controller (DCM)")),
                {"master.dc.gain_ppt", "master.dc.drift_error_gain", "master.dc.max_valid_ns",
                 "master.dc.start_delay_ms", "master.dc.control_off", "master.dc.log"});
  fields().keys(*columns->add(0, tr("Control Loops of the Slaves")),
                {"master.dc.loop.speed_counter_start", "master.dc.loop.filter_depth_difference",
                 "master.dc.loop.filter_depth_speed_counter", "master.dc.standard_loop_values"});
  fields().keys(*columns->add(1, tr("Messages of the Clocks")),
                {"master.dc.notify.reference_clock", "master.dc.notify.slaves_in_sync", "master.dc.notify.dc_status",
                 "master.dc.notify.dcm_in_sync"});
  columns->addStretch();
  setWidget(columns);
}

bool MasterDcExpertPage::appliesTo(int slave) const {
  return slave < 0 && !project().slaves.empty() && fields().wanted(slave);
}

void MasterDcExpertPage::refresh() { fields().refresh(); }

}  // namespace syncline::ui
