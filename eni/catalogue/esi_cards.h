// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/identity.h"
#include "eni/xml/file_warning.h"
#include "support/result.h"

/// What the catalogue keeps of an ESI file: enough to find a device, far less than describes it.
namespace syncline::eni {

/// Device/HideType: a device that this one replaces in lists.
struct HiddenDevice {
  std::uint32_t product_code = 0;
  std::optional<std::uint32_t> revision_no;  // nothing: every revision
  bool operator==(const HiddenDevice&) const = default;
};

struct EsiCard {
  Identity identity;
  int line = 0;
  int place = 0;  // of its Device element among all of the file
  std::string vendor_name, type, name, group_type, group_name, physics;
  std::string revision_rule;  // Type@CheckRevisionNo, "" = none given
  bool invisible = false;     // Device@Invisible
  std::vector<HiddenDevice> hides;
  bool operator==(const EsiCard&) const = default;
};

struct EsiCards {
  std::vector<EsiCard> cards;         // file order
  std::vector<FileWarning> warnings;  // devices that are left out, letters that may be others
};

/// Fingerprints of all Device elements of a file, by EsiCard::place. Takes as long as reading the cards again: for the
/// few devices that are described twice.
[[nodiscard]] Result<std::vector<std::uint64_t>> read_contents(std::string_view text, const std::string& file_name);

/// kXmlMalformed, kFileLimit, kNotThatKindOfFile with file and line. A side file (EtherCATModule, EtherCATDict) has no
/// cards and is no error.
[[nodiscard]] Result<EsiCards> read_cards(std::string_view text, const std::string& file_name);

}  // namespace syncline::eni
