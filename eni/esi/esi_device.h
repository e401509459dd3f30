// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "config/esi_text.h"
#include "config/module_description.h"
#include "config/object_description.h"
#include "eni/esi/esi_side_files.h"
#include "eni/xml/xml_reader.h"

namespace syncline {
struct DcDescription;
struct DeviceDescription;
struct EepromDescription;
}  // namespace syncline

/// The parts of an ESI Device element, one function each. Errors and warnings go to the node's Reading.
namespace syncline::eni {

class XmlPieces;

struct EsiVendor {
  std::uint32_t id = 0;
  std::string name;
};

/// Descriptions/Pdos: PDOs that several devices refer to by name, moved by a number of channels. Older files have them.
using PdoTemplates = std::map<std::string, Node, std::less<>>;

/// What stands around the Device elements of a file.
struct EsiSurroundings {
  EsiVendor vendor;
  std::vector<DeviceGroup> groups{};
  std::vector<ModuleDescription> modules{};
  PdoTemplates pdo_templates{};
  SideFiles* side_files = nullptr;  // none: a reference to another file is a warning
  /// Of a project: the program wrote it, perhaps out of an EEPROM, and takes back whatever it wrote.
  bool written_by_us = false;
};

/// Device element; the caller looks at the Reading before it uses the result.
[[nodiscard]] DeviceDescription read_device(const Node& device, const EsiSurroundings& surroundings);
/// The same without groups and modules.
[[nodiscard]] DeviceDescription read_device(const Node& device, const EsiVendor& vendor, FileWarnings& warnings);

void read_identity(const Node& device, DeviceDescription& description);  // Type, HideType, Name ...
void read_info(const Node& device, DeviceDescription& description);      // Info without Mailbox
[[nodiscard]] EepromDescription read_eeprom(const Node& eeprom);

/// RxPdo, TxPdo.
[[nodiscard]] Pdo read_pdo(const Node& pdo, const PdoTemplates& templates = {});
[[nodiscard]] PdoTemplates read_pdo_templates(const Node& descriptions);
/// kXmlBadValue at the second of two PDOs with the same index.
void check_pdo_indices(const Node& parent, const std::vector<Pdo>& rx_pdos, const std::vector<Pdo>& tx_pdos);

[[nodiscard]] std::vector<Transition> read_transitions(const Node& init_cmd);
[[nodiscard]] StartupCommand read_init_cmd(const Node& init_cmd);  // CoE/InitCmd
[[nodiscard]] CoeDescription read_coe(const Node& coe);
[[nodiscard]] MailboxDescription read_mailbox(const Node& device, const Node& mailbox);  // with Info/Mailbox/Timeout
[[nodiscard]] DcDescription read_dc(const Node& dc);

/// Profile elements of a device or module.
struct ReadProfiles {
  std::vector<ChannelProfile> profiles{};
  std::vector<ObjectDescription> dictionary{};
  std::vector<EnumDescription> enums{};
};
/// Objects of Profile/Dictionary, or of the DictionaryFile, with their data types resolved; an object that cannot be
/// read is left out with a warning, because a device works without its dictionary.
[[nodiscard]] ReadProfiles read_profiles(const Node& parent, SideFiles* side_files);
void read_dictionary(const Node& dictionary, ReadProfiles& profiles);

/// Sub-index 0, then 1, 2 ... of one type, side by side: what ArrayInfo can say.
[[nodiscard]] bool is_uniform_array(const ObjectDescription& object);

[[nodiscard]] std::vector<DeviceGroup> read_groups(const Node& descriptions);
[[nodiscard]] SlotsDescription read_slots(const Node& slots);
/// Module elements; one that cannot be read is left out with a warning.
/// With `pieces` where they are parsed one by one.
[[nodiscard]] std::vector<ModuleDescription> read_modules(const Node& modules, SideFiles* side_files,
                                                          XmlPieces* pieces = nullptr);
/// Device and Module elements of an ESI file, each of which can be read by itself.
[[nodiscard]] bool is_esi_piece(std::string_view element, std::string_view parent);
/// Those that a slot takes, by ident or class, in their order.
[[nodiscard]] std::vector<ModuleDescription> modules_for(const SlotsDescription& slots, std::uint32_t vendor_id,
                                                         const std::vector<ModuleDescription>& modules);

}  // namespace syncline::eni
