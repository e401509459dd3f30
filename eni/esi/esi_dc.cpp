// SPDX-License-Identifier: Apache-2.0
#include "config/dc_description.h"
#include "eni/esi/esi_device.h"
#include "eni/xml/xml_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

DcTime read_time(const Node& node) {
  DcTime time;
  if (!node) return time;
  // <CycleTimeSync0 Factor="1"/> stands for a value of 0.
  if (!node.trimmed().empty()) time.value_ns = node.number<std::int64_t>();
  time.factor = node.number<int>("Factor");
  time.input = node.boolean("Input").value_or(false);
  time.output_delay_ns = node.number<std::int64_t>("OutputDelayTime");
  time.input_delay_ns = node.number<std::int64_t>("InputDelayTime");
  return time;
}

std::optional<OpModeTime> read_op_mode_time(const Node& node) {
  if (!node) return std::nullopt;
  OpModeTime time;
  if (!node.trimmed().empty()) time.value_ns = node.number<std::int64_t>();
  time.factor = node.number<int>("Factor");
  time.min_after_sync_ns = node.number<std::int64_t>("MinAfterSync");
  time.min_before_frame_ns = node.number<std::int64_t>("MinBeforeFrame");
  return time;
}

OpModeSyncManager read_sync_manager(const Node& node) {
  OpModeSyncManager manager;
  if (!node.has("No")) node.fail(ErrorCode::kXmlBadValue, because("the attribute No is missing"));
  manager.number = node.number<std::uint8_t>("No").value_or(0);
  manager.sync_type = node.child_number<std::uint16_t>("SyncType");
  manager.cycle_time = read_op_mode_time(node.child("CycleTime"));
  manager.shift_time = read_op_mode_time(node.child("ShiftTime"));
  for (const Node& pdo : node.children("Pdo")) {
    manager.pdos.push_back(pdo.number<std::uint16_t>());
    if (const auto factor = pdo.number<std::uint16_t>("OSFac"))
      manager.oversampling.push_back({manager.pdos.back(), *factor});
  }
  return manager;
}

std::string read_mode_name(const Node& node) {
  const Node name = node.child("Name");
  const Node description = node.child("Desc");
  if (name || !description || !node.reading().tolerant()) return node.required("Name").trimmed();
  node.warn(because("Name is missing; taken from Desc"));
  return node.localized("Desc").trimmed();
}

DcOpMode read_op_mode(const Node& node) {
  DcOpMode mode;
  mode.name = read_mode_name(node);
  mode.description = node.localized("Desc").trimmed();
  mode.assign_activate = node.child_number<std::uint16_t>("AssignActivate").value_or(0);
  mode.cycle_time_sync0 = read_time(node.child("CycleTimeSync0"));
  mode.shift_time_sync0 = read_time(node.child("ShiftTimeSync0"));
  mode.cycle_time_sync1 = read_time(node.child("CycleTimeSync1"));
  mode.shift_time_sync1 = read_time(node.child("ShiftTimeSync1"));
  for (const Node& manager : node.children("Sm")) mode.sync_managers.push_back(read_sync_manager(manager));
  return mode;
}

}  // namespace

DcDescription read_dc(const Node& node) {
  DcDescription dc;
  dc.time_loop_control_only = node.boolean("TimeLoopControlOnly").value_or(false);
  dc.unknown_frmw = node.boolean("UnknownFRMW").value_or(false);
  dc.unknown_64bit = node.boolean("Unknown64Bit").value_or(false);
  dc.potential_reference_clock = node.boolean("PotentialReferenceClock").value_or(false);
  dc.external_ref_clock = node.boolean("ExternalRefClock").value_or(false);
  dc.pdo_oversampling = node.boolean("PdoOversampling").value_or(false);
  for (const Node& mode : node.children("OpMode")) dc.op_modes.push_back(read_op_mode(mode));
  return dc;
}

}  // namespace syncline::eni
