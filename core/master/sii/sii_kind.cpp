// SPDX-License-Identifier: Apache-2.0
#include "master/sii/sii_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "master/sii/sii_layout.h"
#include "protocol/sii.h"
#include "reasons/because.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::size_t kUnknownSize = 16 * 1024;  // where the size word says less than the header
constexpr std::size_t kMostCategories = 1024;
/// Read on trust behind what is surely needed, so that many slaves of a kind have something to do.
constexpr std::size_t kAhead = 512;

/// What must be the same: words 0 to 0x0D without alias (4) and checksum (7).
std::vector<std::uint8_t> key_of(std::span<const std::uint8_t> own) {
  std::vector<std::uint8_t> key(own.begin(), own.begin() + 28);
  std::fill_n(key.begin() + 8, 2, std::uint8_t{0});
  std::fill_n(key.begin() + 14, 2, std::uint8_t{0});
  return key;
}

bool may_share(std::span<const std::uint8_t> own) {
  const bool has_identity =
      load_le<std::uint32_t>(own.subspan(16)) != 0 && load_le<std::uint32_t>(own.subspan(20)) != 0;
  return has_identity && sii::checksum(own.first(14)) == own[14];
}

}  // namespace

SiiKind::SiiKind(std::vector<std::size_t> who, std::span<const std::uint8_t> own)
    : members(std::move(who)), readers(members), bytes_(own.begin(), own.end()), category_(kSiiHeaderBytes) {}

std::size_t SiiKind::word(std::size_t byte) const { return load_le<std::uint16_t>(std::span(bytes_).subspan(byte)); }

std::size_t SiiKind::limit() const {
  if (bytes_.size() < std::size_t{2} * sii::kSizeWord + 2) return kUnknownSize;
  const auto size = sii::told_size(bytes_);
  return size <= kSiiHeaderBytes ? kUnknownSize : std::min(size, sii::kLongestImage);
}

std::size_t SiiKind::pieces_wanted() const {
  const auto surely = std::max(category_ + 4, bytes_.size() + kSiiPiece);
  const auto end = std::min(limit(), std::max(surely, bytes_.size() + kAhead));
  return (std::max(end, surely) - bytes_.size() + kSiiPiece - 1) / kSiiPiece;
}

void SiiKind::append(std::span<const std::uint8_t> piece) {
  if (done()) return;
  bytes_.insert(bytes_.end(), piece.begin(), piece.end());
  walk();
}

void SiiKind::walk() {
  while (!done() && bytes_.size() >= category_ + 4) {
    const auto type = word(category_), words = word(category_ + 2);
    // The end marker, or an EEPROM that was never written.
    if (type == static_cast<std::size_t>(sii::CategoryType::kEnd) || (type == 0 && words == 0)) {
      done_ = true;
      return;
    }
    const auto end = category_ + 4 + 2 * words;
    if (end > limit()) {
      error_ = Error{
          ErrorCode::kSii, "slave",
          because("category {category} at word 0x{word} of {words} words reaches beyond the EEPROM of {bytes} bytes",
                  type, fmt::format("{:04X}", category_ / 2), words, limit())};
    } else if (++categories_ == kMostCategories) {
      error_ = Error{ErrorCode::kSii, "slave",
                     because("more than {most} categories up to word 0x{word}", kMostCategories,
                             fmt::format("{:04X}", category_ / 2))};
    }
    category_ = end;
  }
  if (!done() && bytes_.size() >= limit()) done_ = true;  // full to the last byte, without an end marker
}

std::vector<SiiKind> find_sii_kinds(std::span<const std::vector<std::uint8_t>> own, bool share) {
  std::vector<SiiKind> kinds;
  std::map<std::vector<std::uint8_t>, std::size_t> known;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].size() < 2 * kOwnSiiWords) continue;
    if (share && may_share(own[i])) {
      const auto [at, fresh] = known.emplace(key_of(own[i]), kinds.size());
      if (!fresh) {
        kinds[at->second].members.push_back(i);
        kinds[at->second].readers.push_back(i);
        continue;
      }
    }
    kinds.emplace_back(std::vector<std::size_t>{i}, own[i]);
  }
  return kinds;
}

}  // namespace syncline
