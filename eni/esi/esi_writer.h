// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace syncline {
struct ChannelProfile;
struct CoeDescription;
struct DcDescription;
struct DeviceDescription;
struct EnumDescription;
struct MailboxDescription;
struct ModuleDescription;
struct ObjectDescription;
struct Pdo;
struct SlotsDescription;
struct StartupCommand;
}  // namespace syncline

namespace syncline::eni {

class XmlWriter;

/// Device element (ETG.2000) of one description. Reading it gives the same description; vendor and source stand around
/// it and are the caller's.
void write_device(XmlWriter& xml, const DeviceDescription& device);
/// Pdo with `tag` RxPdo or TxPdo.
void write_pdo(XmlWriter& xml, std::string_view tag, const Pdo& pdo);
/// Children of an InitCmd element that is open; its attributes are written first.
void write_init_cmd_content(XmlWriter& xml, const StartupCommand& command);
void write_coe(XmlWriter& xml, const CoeDescription& coe);
void write_mailbox(XmlWriter& xml, const MailboxDescription& mailbox);
void write_dc(XmlWriter& xml, const DcDescription& dc);
/// Profile element; nothing when there is nothing to say.
void write_profile(XmlWriter& xml, const std::vector<ChannelProfile>& profiles,
                   const std::vector<ObjectDescription>& objects, const std::vector<EnumDescription>& enums);
/// Dictionary element; nothing when there are no objects.
void write_dictionary(XmlWriter& xml, const std::vector<ObjectDescription>& objects,
                      const std::vector<EnumDescription>& enums);
void write_slots(XmlWriter& xml, const SlotsDescription& slots);
/// Modules element; nothing when there are none.
void write_modules(XmlWriter& xml, const std::vector<ModuleDescription>& modules);

/// A whole ESI file with this one device.
[[nodiscard]] std::string write_esi(const DeviceDescription& device);

}  // namespace syncline::eni
