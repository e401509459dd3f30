// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include "eni/catalogue/catalogue_entry.h"

/// Which ESI entry describes a device that was found on a bus.
namespace syncline::eni {

enum class MatchKind : std::uint8_t {
  kExact,   // this revision, or any revision was asked for
  kRule,    // the vendor lets the entry stand for this revision (CheckRevisionNo)
  kOlder,   // the nearest older revision; nobody promises that it fits
  kNewest,  // all known revisions are newer: the newest of them
};
[[nodiscard]] std::string_view match_kind_name(MatchKind kind);  // "exact", "rule", "older", "newest"

struct CatalogueMatch {
  CatalogueEntry entry;
  MatchKind kind = MatchKind::kExact;
  std::string words;  // why this entry, for the user
};

/// `revisions`: the entries of the identity's vendor and product, revisions ascending, among equal ones the first wins.
/// revision_no 0 in `identity` asks for the newest. Nothing when there are no entries.
[[nodiscard]] std::optional<CatalogueMatch> best_match(std::span<const CatalogueEntry> revisions,
                                                       const Identity& identity);

}  // namespace syncline::eni
