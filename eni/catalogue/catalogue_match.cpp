// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/catalogue_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "eni/catalogue/revision_rule.h"

namespace syncline::eni {
namespace {

std::string revision_text(std::uint32_t revision) { return fmt::format("0x{:08x}", revision); }

std::uint32_t revision_of(const CatalogueEntry& entry) { return entry.identity.revision_no; }

/// The first file's entry of the newest revision that `fits`.
template <class Fits>
const CatalogueEntry* newest(std::span<const CatalogueEntry> revisions, const Fits& fits) {
  const CatalogueEntry* best = nullptr;
  for (const auto& entry : revisions) {
    if (fits(entry) && (best == nullptr || revision_of(entry) > revision_of(*best))) best = &entry;
  }
  return best;
}

/// Somebody who edits the other file would wonder why nothing changes.
std::string rivals_text(std::span<const CatalogueEntry> revisions, const CatalogueEntry& taken) {
  for (const auto& other : revisions) {
    if (other.id == taken.id || revision_of(other) != revision_of(taken) || other.content == taken.content) continue;
    return fmt::format("; {} line {} describes the same revision otherwise and is not used",
                       std::filesystem::path(other.file).filename().string(), other.line);
  }
  return {};
}

CatalogueMatch choose(std::span<const CatalogueEntry> revisions, std::uint32_t wanted) {
  if (wanted == 0) {
    const auto* entry = newest(revisions, [](const auto&) { return true; });
    return {*entry, MatchKind::kExact, fmt::format("revision {}, the newest", revision_text(revision_of(*entry)))};
  }
  if (const auto* entry = newest(revisions, [&](const auto& e) { return revision_of(e) == wanted; })) {
    return {*entry, MatchKind::kExact, fmt::format("revision {}, exactly", revision_text(wanted))};
  }
  const auto fits_older = [&](const auto& e) { return revision_of(e) < wanted; };
  const auto fits_rule = [&](const auto& e) { return revision_fits(e.revision_rule, revision_of(e), wanted); };
  const auto* ruled = newest(revisions, [&](const auto& e) { return fits_rule(e) && fits_older(e); });
  if (ruled == nullptr) ruled = newest(revisions, fits_rule);
  if (ruled != nullptr) {
    return {*ruled, MatchKind::kRule,
            fmt::format("no ESI file has revision {}; the vendor's rule {} of revision {} accepts it ({})",
                        revision_text(wanted), ruled->revision_rule, revision_text(revision_of(*ruled)),
                        revision_rule_words(ruled->revision_rule))};
  }
  if (const auto* older = newest(revisions, fits_older)) {
    return {*older, MatchKind::kOlder,
            fmt::format("no ESI file has revision {} and no rule of the vendor accepts it; the nearest older one is {}",
                        revision_text(wanted), revision_text(revision_of(*older)))};
  }
  const auto* any = newest(revisions, [](const auto&) { return true; });
  return {*any, MatchKind::kNewest,
          fmt::format("no ESI file has revision {} or an older one; the newest one is {}", revision_text(wanted),
                      revision_text(revision_of(*any)))};
}

}  // namespace

std::string_view match_kind_name(MatchKind kind) {
  switch (kind) {
    case MatchKind::kExact:
      return "exact";
    case MatchKind::kRule:
      return "rule";
    case MatchKind::kOlder:
      return "older";
    case MatchKind::kNewest:
      return "newest";
  }
  return {};
}

std::optional<CatalogueMatch> best_match(std::span<const CatalogueEntry> revisions, const Identity& identity) {
  if (revisions.empty()) return std::nullopt;
  auto match = choose(revisions, identity.revision_no);
  match.words += rivals_text(revisions, match.entry);
  return match;
}

}  // namespace syncline::eni
