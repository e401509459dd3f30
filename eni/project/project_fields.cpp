// SPDX-License-Identifier: Apache-2.0
#include "eni/project/project_fields.h"

#include <utility>

#include "config/master_settings.h"
#include "config/slave_settings.h"
#include "config/startup_messages.h"
#include "eni/xml/xml_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

// In all of these `x` is a FieldWriter with a const value or a FieldReader with a mutable one.

constexpr auto sync_window_fields = [](auto& x, auto& window) {
  x.attribute("Enabled", window.enabled);
  x.attribute("Exponent", window.exponent);
  x.attribute("SettleTimeMs", window.settle_time_ms);
};

constexpr auto dcm_fields = [](auto& x, auto& dcm) {
  x.attribute("Mode", dcm.mode);
  x.attribute("SetValueNs", dcm.set_value);
  x.attribute("GainPpt", dcm.gain_ppt);
  x.attribute("DriftErrorGain", dcm.drift_error_gain);
  x.attribute("MaxValidNs", dcm.max_valid_value);
  x.attribute("InSyncLimitNs", dcm.in_sync_limit);
  x.attribute("InSyncSettleTimeMs", dcm.in_sync_settle_time_ms);
  x.attribute("StartDelayMs", dcm.start_delay_ms);
  x.attribute("ControlOff", dcm.control_off);
  x.attribute("StandardLoopValues", dcm.standard_loop_values);
  x.attribute("Log", dcm.log);
};

constexpr auto dc_loop_fields = [](auto& x, auto& loop) {
  x.attribute("SpeedCounterStart", loop.speed_counter_start);
  x.attribute("FilterDepthDifference", loop.filter_depth_difference);
  x.attribute("FilterDepthSpeedCounter", loop.filter_depth_speed_counter);
};

constexpr auto dc_notification_fields = [](auto& x, auto& notifications) {
  x.attribute("ReferenceClock", notifications.reference_clock);
  x.attribute("SlavesInSync", notifications.slaves_in_sync);
  x.attribute("DcStatus", notifications.dc_status);
  x.attribute("DcmInSync", notifications.dcm_in_sync);
};

constexpr auto master_dc_fields = [](auto& x, auto& dc) {
  x.attribute("Enabled", dc.enabled);
  x.attribute("ReferenceClock", dc.reference_clock);
  x.attribute("FirstSlaveIsReferenceClock", dc.first_slave_is_reference_clock);
  x.attribute("AllSlaves", dc.all_slaves);
  x.attribute("ContinuousPropagationCompensation", dc.continuous_propagation_compensation);
  x.attribute("Show64BitSystemTime", dc.show_64bit_system_time);
  x.attribute("BurstTotal", dc.burst_total);
  x.attribute("BurstBulk", dc.burst_bulk);
  x.attribute("BurstEndsEarly", dc.burst_ends_early);
  x.attribute("DelayRounds", dc.delay_rounds);
  x.attribute("DelayDifferenceNs", dc.delay_difference);
  x.attribute("StartTimeSafetyNs", dc.start_time_safety);
  x.attribute("StartTimeGridNs", dc.start_time_grid);
  x.attribute_unless_zero("InputShiftNs", dc.input_shift);
  x.child("Loop", dc.loop, dc_loop_fields);
  x.child("Notifications", dc.notifications, dc_notification_fields);
  x.child("SyncWindow", dc.sync_window, sync_window_fields);
  x.child("Dcm", dc.dcm, dcm_fields);
};

constexpr auto recovery_fields = [](auto& x, auto& recovery) {
  x.attribute("Automatic", recovery.automatic);
  x.attribute("ErrorTries", recovery.error_tries);
  x.attribute("StartIncomplete", recovery.start_incomplete);
};

constexpr auto real_time_fields = [](auto& x, auto& real_time) {
  x.attribute("SpinNs", real_time.spin);
  x.attribute("Cpu", real_time.cpu);
};

constexpr auto image_fields = [](auto& x, auto& image) {
  x.attribute("LogicalStart", image.logical_start);
  x.attribute("Alignment", image.alignment);
  x.attribute("BitPacking", image.bit_packing);
};

constexpr auto task_fields = [](auto& x, auto& task) {
  x.attribute("Multiple", task.multiple);
  x.text("Name", task.name);
};

constexpr auto unit_fields = [](auto& x, auto& unit) {
  x.text("Name", unit.name);
  x.optional_text("Task", unit.task);
};

constexpr auto register_fields = [](auto& x, auto& command) {
  x.attribute("Read", command.read);
  x.attribute("Address", command.address);
  x.attribute("Enabled", command.enabled);
  x.attribute("AfterSlaves", command.after_slaves);
  x.attribute("TimeoutMs", command.timeout_ms);
  x.transitions(command.transitions);
  x.bytes("Data", command.data);
  x.optional_bytes("Expected", command.expected);
  x.optional_bytes("Mask", command.mask);
  x.optional_text("Comment", command.comment);
};

constexpr auto master_fields = [](auto& x, auto& master) {
  x.attribute("CycleTimeNs", master.cycle_time);
  x.attribute("DestinationMac", master.destination_mac);
  x.attribute("SourceMac", master.source_mac);
  x.attribute("OverlapProcessData", master.overlap_process_data);
  x.text("Name", master.name);
  x.child("DistributedClocks", master.dc, master_dc_fields);
  x.child("Recovery", master.recovery, recovery_fields);
  x.child("RealTime", master.real_time, real_time_fields);
  x.unless_default("ProcessImage", master.image, image_fields);
  x.optional_list("RegisterCommands", "InitCmd", master.register_commands, register_fields);
  x.optional_list("Tasks", "Task", master.tasks, task_fields);
  x.optional_list("SyncUnits", "SyncUnit", master.sync_units, unit_fields);
};

constexpr auto previous_fields = [](auto& x, auto& previous) {
  x.attribute("Position", previous.position);
  x.attribute("Port", previous.port);
};

constexpr auto check_fields = [](auto& x, auto& check) {
  x.attribute("Vendor", check.vendor);
  x.attribute("Product", check.product);
  x.attribute("Revision", check.revision);
  x.attribute("Serial", check.serial);
  x.attribute("RevisionRule", check.revision_rule);
  x.attribute("DeviceId", check.device_id);
  x.attribute_if_set("Alias", check.alias);
};

constexpr auto sync_unit_fields = [](auto& x, auto& unit) {
  x.attribute("CycleFactor", unit.cycle_factor);
  x.attribute("UserCycleNs", unit.user_cycle);
  x.attribute("ShiftNs", unit.shift);
};

constexpr auto slave_dc_fields = [](auto& x, auto& dc) {
  x.attribute("PotentialReferenceClock", dc.potential_reference_clock);
  x.attribute("InputReference", dc.input_reference);
  x.text("OpMode", dc.op_mode);
  x.child("Sync0", dc.sync0, sync_unit_fields);
  x.child("Sync1", dc.sync1, sync_unit_fields);
};

constexpr auto startup_fields = [](auto& x, auto& command) {
  x.attribute("Enabled", command.enabled);
  x.attribute("Fixed", command.fixed);
  x.attribute("CompleteAccess", command.complete_access);
  x.attribute("TimeoutMs", command.timeout_ms);
  x.init_cmd(command);
};

constexpr auto message_fields = [](auto& x, auto& message) {
  x.attribute("Enabled", message.enabled);
  x.attribute("Fixed", message.fixed);
  x.attribute("TimeoutMs", message.timeout_ms);
  x.transitions(message.transitions);
  x.bytes("Data", message.data);
  x.optional_text("Comment", message.comment);
};

constexpr auto soe_fields = [](auto& x, auto& soe) {
  x.attribute("Drive", soe.drive);
  x.attribute("Idn", soe.idn);
  message_fields(x, soe);
};

constexpr auto module_fields = [](auto& x, auto& module) {
  x.attribute("Slot", module.slot);
  x.attribute("Ident", module.ident);
};

constexpr auto oversampling_fields = [](auto& x, auto& oversampling) {
  x.attribute("Pdo", oversampling.pdo);
  x.attribute("Factor", oversampling.factor);
};

constexpr auto watchdog_fields = [](auto& x, auto& watchdog) {
  x.attribute("Divider", watchdog.divider);
  x.attribute("Pdi", watchdog.pdi);
  x.attribute("ProcessData", watchdog.process_data);
  x.attribute("Outputs", watchdog.outputs);
};

constexpr auto timeout_fields = [](auto& x, auto& timeouts) {
  x.attribute("PreopMs", timeouts.preop);
  x.attribute("SafeopOpMs", timeouts.safeop_op);
  x.attribute("BackToInitMs", timeouts.back_to_init);
  x.attribute("BackToSafeopMs", timeouts.back_to_safeop);
  x.attribute("MailboxRequestMs", timeouts.mailbox_request);
  x.attribute("MailboxResponseMs", timeouts.mailbox_response);
};

constexpr auto mailbox_fields = [](auto& x, auto& mailbox) {
  x.attribute("OutSize", mailbox.out_size);
  x.attribute("InSize", mailbox.in_size);
  x.attribute("StateBit", mailbox.state_bit);
  x.attribute("PollTimeMs", mailbox.poll_time_ms);
};

constexpr auto eoe_fields = [](auto& x, auto& eoe) {
  x.attribute("Enabled", eoe.enabled);
  x.attribute("Mac", eoe.mac);
  x.optional_text("Ip", eoe.ip);
  x.optional_text("Subnet", eoe.subnet);
  x.optional_text("Gateway", eoe.gateway);
  x.optional_text("Dns", eoe.dns);
  x.optional_text("HostName", eoe.host_name);
};

constexpr auto sync_fields = [](auto& x, auto& sync) {
  x.attribute("ErrorLimit", sync.error_limit);
  x.attribute("Type", sync.type);
  x.attribute("InputShiftNs", sync.input_shift);
};

constexpr auto can_fields = [](auto& x, auto& can) {
  x.attribute("CycleNs", can.cycle);
  x.attribute("TxDelayPercent", can.tx_delay_percent);
};

constexpr auto pin_fields = [](auto& x, auto& pin) {
  x.attribute("Number", pin.pin);
  x.attribute("Function", pin.function);
};

constexpr auto variable_fields = [](auto& x, auto& variable) {
  x.attribute("Pdo", variable.pdo);
  x.attribute("Entry", variable.entry);
  x.text("Name", variable.name);
};

constexpr auto slave_fields = [](auto& x, auto& slave) {
  x.attribute("StationAddress", slave.station_address);
  x.attribute("Alias", slave.alias);
  x.attribute_if_set("Optional", slave.optional);
  x.text("Name", slave.name);
  x.optional_text("HotConnect", slave.hot_connect);
  x.child("Previous", slave.previous, previous_fields);
  x.child("Check", slave.check, check_fields);
  x.indices("RxPdos", slave.assigned_rx_pdos);
  x.indices("TxPdos", slave.assigned_tx_pdos);
  x.pdos("ChangedPdos", slave.changed_pdos);
  x.child("DistributedClocks", slave.dc, slave_dc_fields);
  x.list("Startup", "InitCmd", slave.startup, startup_fields);
  x.optional_list("SoeStartup", "InitCmd", slave.soe_startup, soe_fields);
  for (const auto& protocol : kMessageProtocols) {
    const auto name = std::string(protocol.name) + "Startup";
    x.list_unless(name.c_str(), "InitCmd", slave.*protocol.startup, esi_messages(slave.device, protocol.type),
                  message_fields);
  }
  x.optional_list("RegisterCommands", "InitCmd", slave.register_commands, register_fields);
  x.optional_list("Modules", "Module", slave.modules, module_fields);
  x.optional_list("Oversampling", "Pdo", slave.oversampling, oversampling_fields);
  x.unless_default("Watchdog", slave.watchdog, watchdog_fields);
  x.unless_default("Timeouts", slave.timeouts, timeout_fields);
  x.unless_default("Mailbox", slave.mailbox, mailbox_fields);
  x.unless_default("Eoe", slave.eoe, eoe_fields);
  x.optional_text("AmsNetId", slave.ams_net_id);
  x.optional_text("OutputUnit", slave.output_unit);
  x.optional_text("InputUnit", slave.input_unit);
  x.optional_list("VariableNames", "Variable", slave.variable_names, variable_fields);
  x.unless_default("Sync", slave.sync, sync_fields);
  x.unless_default("Can", slave.can, can_fields);
  x.optional_list("OutputPins", "Pin", slave.output_pins, pin_fields);
};

}  // namespace

void FieldReader::indices(const char* name, std::vector<std::uint16_t>& values) {
  const Node found = node_.child(name);
  const auto text = found.trimmed();
  for (std::string_view rest = text; !rest.empty(); rest = trim(rest)) {
    const auto word = rest.substr(0, rest.find_first_of(" \t\r\n"));
    const auto index = parse_number(word);
    if (!index || *index < 0 || *index > 0xFFFF) {
      return found.fail(ErrorCode::kXmlBadValue, because("\"{text}\" is no PDO index", word));
    }
    values.push_back(static_cast<std::uint16_t>(*index));
    rest.remove_prefix(word.size());
  }
}

void FieldReader::transitions(std::vector<Transition>& values) {
  values.clear();
  for (const Node& node : node_.children("Transition")) {
    const auto transition = transition_from_name(node.trimmed());
    if (!transition) return node.fail(ErrorCode::kXmlBadValue, because("\"{text}\" is no transition", node.trimmed()));
    values.push_back(*transition);
  }
}

void FieldReader::init_cmd(StartupCommand& command) {
  auto read = read_init_cmd(node_);
  read.enabled = command.enabled;
  read.fixed = command.fixed;
  read.complete_access = command.complete_access;
  read.timeout_ms = command.timeout_ms;
  command = std::move(read);
}

void write_fields(FieldWriter& writer, const MasterSettings& master) { master_fields(writer, master); }
void read_fields(FieldReader& reader, MasterSettings& master) { master_fields(reader, master); }
void write_fields(FieldWriter& writer, const SlaveSettings& slave) { slave_fields(writer, slave); }
void read_fields(FieldReader& reader, SlaveSettings& slave) { slave_fields(reader, slave); }

}  // namespace syncline::eni
