// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/esi_cards.h"

#include <algorithm>
#include <map>

#include "eni/catalogue/content_hash.h"
#include "eni/catalogue/revision_rule.h"
#include "eni/esi/esi_device.h"
#include "eni/xml/xml_pieces.h"
#include "eni/xml/xml_reader.h"
#include "eni/xml/xml_text.h"
#include "findings/error_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

class InfoReader {
 public:
  InfoReader(const Node& info, XmlPieces& pieces, EsiCards& found, int& place)
      : info_(info), pieces_(pieces), found_(found), place_(place) {}

  void read() {
    const Node vendor = info_.required("Vendor");
    vendor_id_ = vendor.required("Id").number<std::uint32_t>();
    vendor_name_ = vendor.localized("Name").trimmed();
    const Node descriptions = info_.required("Descriptions");
    for (const Node& group : descriptions.child("Groups").children("Group")) {
      group_names_.emplace(group.child("Type").trimmed(), group.localized("Name").trimmed());
    }
    for (const Node& stub : descriptions.child("Devices").children("Device")) {
      if (const Node device = pieces_.whole(stub)) read_device(device, place_++);
    }
  }

 private:
  void read_device(const Node& given, int place) {
    Reading reading = given.reading().of_part();  // its own: one broken device must not take the others with it
    const Node device = given.with(reading);
    if (!has_controller(device)) return;
    EsiCard card = read_card(device);
    if (reading.ok()) {
      card.place = place;
      found_.cards.push_back(std::move(card));
      return;
    }
    const Error& error = *reading.error();
    found_.warnings.push_back({error.file, error.line, error.subject,
                               because("Device {device} is left out: {error}", trim(card.type), reason_of(error))});
  }

  /// End caps, power supplies and the like stand in ESI files so that cabinets can be drawn: no product code, nothing
  /// of an EtherCAT slave controller. On the bus there is nobody; a slave with an empty EEPROM must not be taken for
  /// one.
  static bool has_controller(const Node& device) {
    if (device.child("Type").has("ProductCode")) return true;
    constexpr const char* kParts[] = {"Fmmu", "Sm", "RxPdo", "TxPdo", "Mailbox", "Dc", "Eeprom"};
    return std::ranges::any_of(kParts, [&](const char* part) { return static_cast<bool>(device.child(part)); });
  }

  EsiCard read_card(const Node& device) {
    const Node type = device.required("Type");
    EsiCard card;
    card.line = device.line();
    card.type = type.text();
    card.identity.vendor_id = vendor_id_;
    card.identity.product_code = type.number<std::uint32_t>("ProductCode").value_or(0);
    card.identity.revision_no = type.number<std::uint32_t>("RevisionNo").value_or(0);
    card.vendor_name = vendor_name_;
    card.name = device.child("Name") ? device.localized("Name").trimmed() : std::string(trim(card.type));
    card.group_type = device.child("GroupType").trimmed();
    if (const auto group = group_names_.find(card.group_type); group != group_names_.end())
      card.group_name = group->second;
    card.physics = device.attribute("Physics");
    card.revision_rule = type.attribute("CheckRevisionNo");
    card.invisible = is_true(device.attribute("Invisible"));
    for (const Node& hide : device.children("HideType")) read_hide(hide, card);
    return card;
  }

  /// A reference that names neither product nor revision (the legacy @ProductRevision alone) hides nothing here.
  static void read_hide(const Node& hide, EsiCard& card) {
    Reading tolerant(hide.reading().file());
    const Node node = hide.with(tolerant);
    const auto product = node.number<std::uint32_t>("ProductCode");
    const auto revision = node.number<std::uint32_t>("RevisionNo");
    if (!tolerant.ok() || (!product && !revision)) return;
    card.hides.push_back({product.value_or(card.identity.product_code), revision});
  }

  static bool is_true(std::string_view text) { return parse_bool(text).value_or(false); }

  Node info_;
  XmlPieces& pieces_;
  EsiCards& found_;
  int& place_;
  std::uint32_t vendor_id_ = 0;
  std::string vendor_name_;
  std::map<std::string, std::string, std::less<>> group_names_;
};

}  // namespace

Result<EsiCards> read_cards(std::string_view text, const std::string& file_name) {
  auto pieces = XmlPieces::parse(text, file_name, is_esi_piece);
  if (!pieces) return tl::unexpected(pieces.error());
  FileWarnings tolerated;  // whoever reads the whole device tells of them
  Reading reading(file_name, tolerated);
  const Node root(pieces->root(), reading);
  EsiCards found;
  if (const auto& doubt = pieces->doubt()) found.warnings.push_back({file_name, doubt->line, "?xml", doubt->reason});
  int place = 0;
  if (root.name() == "EtherCATInfo") {
    InfoReader(root, *pieces, found, place).read();
  } else if (root.name() == "EtherCATInfoList") {
    for (const Node& info : root.children("EtherCATInfo")) InfoReader(info, *pieces, found, place).read();
  } else if (root.name() != "EtherCATModule" && root.name() != "EtherCATDict") {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile,
                      .subject = std::string(root.name()),
                      .detail = because("an ESI file with the root <EtherCATInfo>, not <{root}>", root.name()),
                      .file = file_name,
                      .line = root.line()});
  }
  if (pieces->error()) return tl::unexpected(*pieces->error());
  if (!reading.ok()) return tl::unexpected(*reading.error());
  return found;
}

Result<std::vector<std::uint64_t>> read_contents(std::string_view text, const std::string& file_name) {
  auto pieces = XmlPieces::parse(text, file_name, is_esi_piece);
  if (!pieces) return tl::unexpected(pieces.error());
  Reading reading(file_name);
  const Node root(pieces->root(), reading);
  std::vector<std::uint64_t> contents;
  for (const Node& info : root.name() == "EtherCATInfoList" ? root.children("EtherCATInfo") : std::vector<Node>{root}) {
    for (const Node& stub : info.child("Descriptions").child("Devices").children("Device")) {
      if (const Node device = pieces->whole(stub)) contents.push_back(content_hash(*device.element()));
    }
  }
  if (pieces->error()) return tl::unexpected(*pieces->error());
  return contents;
}

}  // namespace syncline::eni
