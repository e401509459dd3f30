// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "config/dc_description.h"
#include "eni/esi/esi_attributes.h"
#include "eni/esi/esi_writer.h"

namespace syncline::eni {
namespace {

void write_time(XmlWriter& xml, std::string_view name, const DcTime& time) {
  if (time == DcTime{}) return;
  xml.open(name);
  optional_attribute(xml, "Factor", time.factor);
  flag(xml, "Input", time.input);
  optional_attribute(xml, "OutputDelayTime", time.output_delay_ns);
  optional_attribute(xml, "InputDelayTime", time.input_delay_ns);
  xml.text(decimal(time.value_ns)).close();
}

void write_op_mode_time(XmlWriter& xml, std::string_view name, const std::optional<OpModeTime>& time) {
  if (!time) return;
  xml.open(name);
  optional_attribute(xml, "Factor", time->factor);
  optional_attribute(xml, "MinAfterSync", time->min_after_sync_ns);
  optional_attribute(xml, "MinBeforeFrame", time->min_before_frame_ns);
  xml.text(decimal(time->value_ns)).close();
}

void write_sync_manager(XmlWriter& xml, const OpModeSyncManager& manager) {
  xml.open("Sm").attribute("No", decimal(manager.number));
  optional_element(xml, "SyncType", manager.sync_type);
  write_op_mode_time(xml, "CycleTime", manager.cycle_time);
  write_op_mode_time(xml, "ShiftTime", manager.shift_time);
  for (const auto index : manager.pdos) {
    xml.open("Pdo");
    const auto oversampled = std::ranges::find(manager.oversampling, index, &PdoOversampling::pdo);
    if (oversampled != manager.oversampling.end()) xml.attribute("OSFac", decimal(oversampled->factor));
    xml.text(hex_dec(index)).close();
  }
  xml.close();
}

void write_op_mode(XmlWriter& xml, const DcOpMode& mode) {
  xml.open("OpMode").element("Name", mode.name);
  text_element(xml, "Desc", mode.description);
  xml.element("AssignActivate", hex_dec(mode.assign_activate));
  write_time(xml, "CycleTimeSync0", mode.cycle_time_sync0);
  write_time(xml, "ShiftTimeSync0", mode.shift_time_sync0);
  write_time(xml, "CycleTimeSync1", mode.cycle_time_sync1);
  write_time(xml, "ShiftTimeSync1", mode.shift_time_sync1);
  for (const OpModeSyncManager& manager : mode.sync_managers) write_sync_manager(xml, manager);
  xml.close();
}

}  // namespace

void write_dc(XmlWriter& xml, const DcDescription& dc) {
  xml.open("Dc");
  flag(xml, "TimeLoopControlOnly", dc.time_loop_control_only);
  flag(xml, "UnknownFRMW", dc.unknown_frmw);
  flag(xml, "Unknown64Bit", dc.unknown_64bit);
  flag(xml, "PotentialReferenceClock", dc.potential_reference_clock);
  flag(xml, "ExternalRefClock", dc.external_ref_clock);
  flag(xml, "PdoOversampling", dc.pdo_oversampling);
  for (const DcOpMode& mode : dc.op_modes) write_op_mode(xml, mode);
  xml.close();
}

}  // namespace syncline::eni
