// SPDX-License-Identifier: Apache-2.0
#include "eni/esi/diag_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <unordered_set>

#include "eni/esi/esi_device.h"
#include "eni/esi/esi_reader.h"
#include "eni/esi/esi_side_files.h"
#include "eni/xml/xml_pieces.h"
#include "eni/xml/xml_text.h"
#include "reasons/because.h"

namespace syncline::eni {
namespace {

class MessagesReader {
 public:
  MessagesReader(const Identity& identity, XmlPieces& pieces, SideFiles* side_files)
      : identity_(identity), pieces_(pieces), side_files_(side_files) {}

  /// False: the device is not in the file.
  bool read(const Node& root) {
    const auto infos = root.name() == "EtherCATInfoList" ? root.children("EtherCATInfo") : std::vector<Node>{root};
    for (const Node& info : infos) {
      if (const Node device = device_of(info)) {
        take_profiles(device);
        const Node modules = info.child("Descriptions").child("Modules");
        for (const Node& module : modules.children("Module")) take_profiles(pieces_.whole(module));
        return true;
      }
    }
    return false;
  }
  std::vector<DiagMessageText> take() { return std::move(texts_); }

 private:
  [[nodiscard]] Node device_of(const Node& info) {
    if (info.child("Vendor").child_number<std::uint32_t>("Id") != identity_.vendor_id) return {};
    for (const Node& stub : info.child("Descriptions").child("Devices").children("Device")) {
      const Node device = pieces_.whole(stub);
      if (!device) return {};
      Reading part = device.reading().of_part();  // another device's number that is none is not our trouble
      const Node type = device.with(part).child("Type");
      if (type.number<std::uint32_t>("ProductCode").value_or(0) == identity_.product_code &&
          type.number<std::uint32_t>("RevisionNo").value_or(0) == identity_.revision_no && part.ok()) {
        return device;
      }
    }
    return {};
  }

  void take_profiles(const Node& parent) {
    for (const Node& profile : parent.children("Profile")) {
      take_messages(profile.child("DiagMessages"));
      for (const Node& reference : profile.children("DiagFile")) take_file(reference.trimmed());
    }
  }

  /// A file that is not there takes its texts with it: numbers are shown then.
  void take_file(const std::string& name) {
    if (side_files_ == nullptr || !side_files_->visit(name)) return;
    const auto file = side_files_->open(name);
    if (file && (*file)->root().name() == "EtherCATDiag") take_messages((*file)->root().child("DiagMessages"));
  }

  void take_messages(const Node& messages) {
    for (const Node& node : messages.children("DiagMessage")) {
      Reading part = node.reading().of_part();
      const Node message = node.with(part);
      DiagMessageText text{.text_id = message.required("TextId").number<std::uint16_t>(),
                           .text = message.localized("MessageText").trimmed(),
                           .description = message.localized("Description").trimmed()};
      if (part.ok() && known_.insert(text.text_id).second) texts_.push_back(std::move(text));
    }
  }

  const Identity& identity_;
  XmlPieces& pieces_;
  SideFiles* side_files_;
  std::vector<DiagMessageText> texts_;
  std::unordered_set<std::uint16_t> known_;
};

Result<std::vector<DiagMessageText>> read_messages(std::string_view text, const std::string& file_name,
                                                   const Identity& identity, const EsiReadOptions& options,
                                                   bool with_side_files) {
  auto pieces = XmlPieces::parse(text, file_name, is_esi_piece);
  if (!pieces) return tl::unexpected(pieces.error());
  FileWarnings tolerated;  // whoever reads the whole device tells of them
  Reading reading(file_name, tolerated, options.language);
  std::optional<SideFiles> side_files;
  if (with_side_files) side_files.emplace(std::filesystem::path(file_name).parent_path(), reading);
  MessagesReader reader(identity, *pieces, side_files ? &*side_files : nullptr);
  const bool found = reader.read({pieces->root(), reading});
  if (pieces->error()) return tl::unexpected(*pieces->error());
  if (found) return reader.take();
  return fail(ErrorCode::kUnknownDevice, file_name, because("{device} is not in the file", to_string(identity)));
}

}  // namespace

Result<std::vector<DiagMessageText>> read_diag_messages(const std::string& esi_path, const Identity& identity,
                                                        const EsiReadOptions& options) {
  const auto text = read_file(esi_path);
  if (!text) return tl::unexpected(text.error());
  return read_messages(*text, esi_path, identity, options, true);
}

Result<std::vector<DiagMessageText>> parse_diag_messages(std::string_view text, const std::string& file_name,
                                                         const Identity& identity, const EsiReadOptions& options) {
  return read_messages(text, file_name, identity, options, false);
}

const DiagMessageText* find_text(const std::vector<DiagMessageText>& texts, std::uint16_t text_id) {
  const auto found = std::ranges::find(texts, text_id, &DiagMessageText::text_id);
  return found == texts.end() ? nullptr : &*found;
}

}  // namespace syncline::eni
