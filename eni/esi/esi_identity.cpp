// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include "config/device_description.h"
#include "eni/esi/esi_check_words.h"
#include "eni/esi/esi_device.h"
#include "eni/esi/esi_words.h"
#include "eni/xml/xml_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

std::optional<RevisionCheck> read_revision_check(const Node& type) {
  if (!type.has("CheckRevisionNo")) return std::nullopt;
  const auto text = type.attribute("CheckRevisionNo");
  for (const auto& word : kRevisionChecks) {
    if (word.text == text) return word.check;
  }
  if (!text.empty()) type.warn(because("the rule \"{rule}\" for {attribute} is not known", text, "CheckRevisionNo"));
  return std::nullopt;
}

/// CheckProductCode and CheckSerialNo.
std::optional<bool> read_check(const Node& type, const char* attribute) {
  const auto text = type.attribute(attribute);
  if (text == "EQ") return true;
  if (text == "NONE") return false;
  if (!text.empty()) type.warn(because("the rule \"{rule}\" for {attribute} is not known", text, attribute));
  return std::nullopt;
}

/// A reference that cannot be read concerns catalogues only; the device works without it.
std::optional<std::uint32_t> reference_number(const Node& node, const char* attribute) {
  if (!node.has(attribute)) return std::nullopt;
  Reading part = node.reading().of_part();
  const auto number = node.with(part).number<std::uint32_t>(attribute);
  if (part.ok()) return number;
  node.warn(
      because("{attribute} \"{text}\" is no number of 32 bits and is left out", attribute, node.attribute(attribute)));
  return std::nullopt;
}

std::vector<DeviceReference> read_references(const Node& device, const char* tag) {
  std::vector<DeviceReference> references;
  for (const Node& node : device.children(tag)) {
    references.push_back({.type = node.trimmed(),
                          .product_code = reference_number(node, "ProductCode"),
                          .revision_no = reference_number(node, "RevisionNo"),
                          .product_revision = node.attribute("ProductRevision")});
  }
  return references;
}

void read_type(const Node& type, DeviceDescription& device) {
  device.type = type.text();  // not trimmed: configurators build slave names from it as it stands
  device.identity.product_code = type.number<std::uint32_t>("ProductCode").value_or(0);
  device.identity.revision_no = type.number<std::uint32_t>("RevisionNo").value_or(0);
  device.identity.serial_no = type.number<std::uint32_t>("SerialNo").value_or(0);
  device.check_product_code = read_check(type, "CheckProductCode");
  device.check_serial_no = read_check(type, "CheckSerialNo");
  device.check_revision = read_revision_check(type);
  device.use_lrd_lwr = type.boolean("UseLrdLwr").value_or(false);
  device.module_pdo_group = type.number<int>("ModulePdoGroup");
  device.download_module_list = type.boolean("DownloadModuleList").value_or(false);
}

}  // namespace

void read_identity(const Node& node, DeviceDescription& device) {
  read_type(node.required("Type"), device);
  device.name = node.child("Name") ? node.localized("Name").trimmed() : std::string(trim(device.type));
  device.names = read_texts(node, "Name");
  device.group_type = node.child("GroupType").trimmed();
  device.physics = node.attribute("Physics");
  device.invisible = node.boolean("Invisible").value_or(false);
  device.hides = read_references(node, "HideType");
  device.alternatives = read_references(node, "AlternativeType");
  device.sub_devices = read_references(node, "SubDevice");
  device.image = read_image(node);
}

}  // namespace syncline::eni
