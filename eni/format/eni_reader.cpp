// SPDX-License-Identifier: Apache-2.0
#include "eni/format/eni_reader.h"

#include <algorithm>

#include "eni/format/eni_element.h"
#include "eni/format/eni_end_cap.h"
#include "eni/format/eni_file.h"
#include "eni/xml/xml_pieces.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

void read_mac(const EniElement& element, std::array<std::uint8_t, 6>& mac) {
  if (!element) {
    return;
  }
  const auto bytes = element.bytes();
  if (bytes.size() == mac.size()) {
    std::ranges::copy(bytes, mac.begin());
  } else {
    element.report(ErrorCode::kXmlBadValue, element.text());
  }
}

std::optional<std::uint8_t> read_port(const EniElement& element) {
  const std::string port = element.text_of("Port");
  if (port.size() != 1 || port[0] < 'A' || port[0] > 'D') {
    element.child("Port").report(ErrorCode::kXmlBadValue, port);
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(port[0] - 'A');
}

/// Station address of the selected previous port, 0 = none.
std::uint16_t read_previous(const EniElement& slave, SlaveConfig& config) {
  const auto ports = slave.children("PreviousPort");
  auto selected = std::ranges::find_if(ports, [](const EniElement& p) { return p.boolean_attribute("Selected"); });
  if (selected == ports.end() && ports.size() == 1) {
    selected = ports.begin();
  }
  for (auto port = ports.begin(); port != ports.end(); ++port) {
    if (const auto number = port == selected ? std::nullopt : read_port(*port)) {
      config.other_ports.push_back({*number, (*port).optional_number_of<std::uint16_t>("PhysAddr"),
                                    (*port).optional_number_of<std::uint32_t>("DeviceId")});
    }
  }
  const auto port = selected == ports.end() ? std::nullopt : read_port(*selected);
  if (!port) {
    return 0;
  }
  config.previous = PreviousPort{0, *port};
  return (*selected).number_of<std::uint16_t>("PhysAddr");
}

Result<NetworkConfig> read_config(const EniElement& root, const Reading& reading, XmlPieces& pieces) {
  const auto whole = [&pieces](const EniElement& part) { return EniElement(pieces.whole(part.node())); };
  const EniElement config_element = root.required("Config");
  NetworkConfig config;
  config.master = read_master(config_element.required("Master"));
  std::vector<std::uint16_t> previous_addresses;
  for (const EniElement& stub : config_element.children("Slave")) {
    const EniElement slave = whole(stub);
    if (!slave || !reading.ok()) break;
    if (is_end_cap(*slave.element())) continue;
    config.slaves.push_back(read_slave(slave, static_cast<std::uint16_t>(config.slaves.size())));
    previous_addresses.push_back(read_previous(slave, config.slaves.back()));
  }
  for (const EniElement& cyclic : config_element.children("Cyclic")) {
    config.cyclic.push_back(read_cyclic(whole(cyclic)));
  }
  config.image = read_process_image(whole(config_element.child("ProcessImage")));
  if (pieces.error()) return fail(*pieces.error());
  if (reading.error()) {
    return fail(*reading.error());
  }
  derive_network(config, previous_addresses);
  return config;
}

}  // namespace

bool is_eni_piece(std::string_view element, std::string_view parent) {
  return parent == "Config" && (element == "Slave" || element == "Cyclic" || element == "ProcessImage");
}

MasterConfig read_master(const EniElement& master) {
  MasterConfig config;
  const EniElement info = master.child("Info");
  config.name = info.text_of("Name");
  read_mac(info.child("Destination"), config.destination_mac);
  read_mac(info.child("Source"), config.source_mac);
  if (const auto type = info.child("EtherType") ? info.child("EtherType").bytes() : std::vector<std::uint8_t>{};
      type.size() == 2) {
    config.ether_type = static_cast<std::uint16_t>(type[0] | type[1] << 8);
  }
  if (const EniElement eoe = master.child("EoE")) {
    config.eoe = true;
    config.eoe_settings = {eoe.number_of<std::uint32_t>("MaxPorts"), eoe.number_of<std::uint32_t>("MaxFrames"),
                           eoe.number_of<std::uint32_t>("MaxMACs")};
  }
  if (const EniElement states = master.child("MailboxStates")) {
    config.mailbox_state_count = states.optional_number_of<std::uint16_t>("Count");
    config.mailbox_state_start = states.number_of<std::uint32_t>("StartAddr", config.mailbox_state_start);
  }
  config.init_cmds = read_init_cmds(master.child("InitCmds"));
  return config;
}

Result<NetworkConfig> parse_eni(std::string_view text, const std::string& file_name) {
  auto pieces = XmlPieces::parse(text, file_name, is_eni_piece);
  if (!pieces) return fail(pieces.error());
  const std::string_view root_name = pieces->root()->Name();
  // "Encrypted..." is an OEM export whose content is plain in the field.
  if (root_name != "EtherCATConfig" && root_name != "EncryptedEtherCATConfig") {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile,
                      .detail = because("an ENI file (root element EtherCATConfig)"),
                      .file = file_name});
  }
  Reading reading(file_name);
  const EniElement element(Node(pieces->root(), reading));
  if (root_name == "EncryptedEtherCATConfig" && !element.child("Config")) {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile,
                      .detail = because("an ENI file that others can read: its maker has encrypted it"),
                      .file = file_name});
  }
  return read_config(element, reading, *pieces);
}

Result<NetworkConfig> read_eni(const std::string& path) {
  const auto text = read_file(path);
  return text ? parse_eni(*text, path) : fail(text.error());
}

}  // namespace syncline::eni
