// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/catalogue_query.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <tuple>

#include "eni/catalogue/catalogue_entry.h"
#include "eni/catalogue/catalogue_store.h"
#include "eni/catalogue/esi_cards.h"
#include "eni/catalogue/revision_words.h"
#include "eni/xml/xml_text.h"
#include "support/utf8.h"

namespace syncline::eni {
namespace {

/// Rows that have all the words; where a revision is named, few of them remain.
constexpr std::int64_t kMostByWords = 2'000, kMostWithRevision = 100'000;

// Which columns an entry is read from; the tables are d = devices, f = files.
#define ENTRY_COLUMNS                                                                                             \
  "d.id, d.vendor_id, d.product_code, d.revision_no, d.vendor_name, d.type, d.name, d.group_type, d.group_name, " \
  "d.physics, d.revision_rule, d.invisible, f.path, d.line, d.content, d.place"

CatalogueEntry entry_of(const SqlStatement& row) {
  const auto text = [&row](int column) { return std::string(row.text(column)); };
  const auto number = [&row](int column) { return static_cast<std::uint32_t>(row.integer(column)); };
  CatalogueEntry entry;
  entry.id = row.integer(0);
  entry.identity = {number(1), number(2), number(3), 0};
  entry.vendor_name = text(4);
  entry.type = text(5);
  entry.name = text(6);
  entry.group_type = text(7);
  entry.group_name = text(8);
  entry.physics = text(9);
  entry.revision_rule = text(10);
  entry.hidden = row.integer(11) != 0;
  entry.file = text(12);
  entry.line = static_cast<int>(row.integer(13));
  entry.content = std::bit_cast<std::uint64_t>(row.integer(14));
  entry.place = static_cast<int>(row.integer(15));
  return entry;
}

/// A device that another one of a chosen file hides (HideType).
Status mark_hidden(CatalogueStore& store, CatalogueEntry& entry) {
  if (entry.hidden) return {};
  auto query = store.database().prepare(
      "SELECT 1 FROM hides h JOIN devices d ON d.id = h.device JOIN chosen ON chosen.file = d.file "
      "WHERE h.vendor_id = ?1 AND h.product_code = ?2 AND (h.revision_no = ?3 OR h.revision_no IS NULL) AND h.device "
      "<> ?4 LIMIT 1");
  if (!query) return tl::unexpected(query.error());
  const Identity& identity = entry.identity;
  query->bind(0, identity.vendor_id).bind(1, identity.product_code).bind(2, identity.revision_no).bind(3, entry.id);
  return query->each([&] { entry.hidden = true; });
}

/// "EL20 dig" as an FTS5 expression: every word, as the beginning of one in the text.
std::string match_expression(std::string_view words) {
  std::string expression, word;
  const auto end_word = [&] {
    if (word.starts_with("0x")) {  // as product codes are kept: without zeros in front
      const auto digit = word.find_first_not_of('0', 2);
      word = "x" + (digit == std::string::npos ? std::string() : word.substr(digit));
    }
    if (!word.empty()) expression.append(expression.empty() ? "\"" : " \"").append(word).append("\"*");
    word.clear();
  };
  for (const char c : words) {
    const bool separates = static_cast<unsigned char>(c) < 0x80 &&
                           !((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'));
    if (separates) {
      end_word();
    } else {
      word += c;
    }
  }
  end_word();
  return expression;
}

/// Takes the rows that come in order, until there are enough.
class Picker {
 public:
  Picker(CatalogueStore& store, const CatalogueSearch& search, const RevisionWords& wanted)
      : store_(store), search_(search), wanted_(wanted) {}

  [[nodiscard]] bool full() const { return picked_.size() >= search_.limit; }
  [[nodiscard]] Status error() const { return error_; }
  [[nodiscard]] std::vector<CatalogueEntry> take() { return std::move(picked_); }

  /// False: no more are wanted.
  bool offer(CatalogueEntry entry) {
    if (full()) return false;
    if (!seen_.insert(entry.id).second || !fits(entry)) return true;
    if (error_ = mark_hidden(store_, entry); !error_) return false;
    // Who names a revision means it, be it old or hidden by a newer one.
    const bool named = wanted_.name_revision(entry.identity);
    if (entry.hidden && !search_.with_hidden && !named) return true;
    const Identity& identity = entry.identity;
    const bool is_new = types_.emplace(identity.vendor_id, identity.product_code, entry.type).second;
    if (search_.all_revisions || is_new || named) picked_.push_back(std::move(entry));
    return !full();
  }

 private:
  [[nodiscard]] bool fits(const CatalogueEntry& entry) const {
    return (!search_.vendor_id || *search_.vendor_id == entry.identity.vendor_id) &&
           (!search_.product_code || *search_.product_code == entry.identity.product_code) &&
           (search_.group_type.empty() || search_.group_type == entry.group_type) && wanted_.fit(entry.identity);
  }

  CatalogueStore& store_;
  const CatalogueSearch& search_;
  const RevisionWords& wanted_;
  Status error_;
  std::set<std::int64_t> seen_;
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::string>> types_;
  std::vector<CatalogueEntry> picked_;
};

/// Types that begin with the words: the index has them in order.
Status offer_types(CatalogueStore& store, std::string_view prefix, Picker& picker) {
  auto query = store.database().prepare(
      "SELECT " ENTRY_COLUMNS
      " FROM devices d CROSS JOIN chosen ON chosen.file = d.file JOIN files f ON f.id = d.file "
      "WHERE d.type >= ? AND d.type < ? ORDER BY d.type, d.revision_no DESC");
  if (!query) return tl::unexpected(query.error());
  const std::string beyond = std::string(prefix) + "\xF4\x8F\xBF\xBF";  // U+10FFFF, behind every other character
  query->bind(0, prefix).bind(1, beyond);
  if (auto status = query->each([&] { return picker.offer(entry_of(*query)); }); !status) return status;
  return picker.error();
}

/// Whatever has all the words somewhere. Beyond `most` nobody reads on, but types more.
Status offer_words(CatalogueStore& store, const std::string& expression, std::int64_t most, Picker& picker) {
  auto query = store.database().prepare("SELECT " ENTRY_COLUMNS
                                        " FROM (SELECT rowid FROM words WHERE words MATCH ? LIMIT ?) w "
                                        "CROSS JOIN devices d ON d.id = w.rowid CROSS JOIN chosen ON chosen.file = "
                                        "d.file CROSS JOIN files f ON f.id = d.file "
                                        "ORDER BY d.type, d.revision_no DESC, chosen.rank, d.id");
  if (!query) return tl::unexpected(query.error());
  if (auto status = query->bind(0, expression).bind(1, most).each([&] { return picker.offer(entry_of(*query)); });
      !status)
    return status;
  return picker.error();
}

/// Entries of which another one has the identity get the fingerprints of their contents: from the store, else from
/// their files, and into the store.
Status compare_contents(CatalogueStore& store, std::vector<CatalogueEntry>& entries) {
  std::map<std::string, std::vector<std::uint64_t>> read;
  std::map<std::uint32_t, std::size_t> of_revision;  // the entries are of one vendor and product
  for (const auto& entry : entries) ++of_revision[entry.identity.revision_no];
  for (auto& entry : entries) {
    if (entry.content != 0 || of_revision[entry.identity.revision_no] < 2) continue;
    const auto [contents, is_new] = read.try_emplace(entry.file);
    if (is_new) {
      if (const auto text = read_file(entry.file))
        contents->second = read_contents(*text, entry.file).value_or(contents->second);
      if (auto status = store.put_contents(entry.file, contents->second); !status) return status;
    }
    const auto place = static_cast<std::size_t>(entry.place);
    if (place < contents->second.size()) entry.content = contents->second[place];
  }
  return {};
}

}  // namespace

Result<std::vector<CatalogueEntry>> entries_of(CatalogueStore& store, std::uint32_t vendor_id,
                                               std::uint32_t product_code) {
  auto query = store.database().prepare(
      "SELECT " ENTRY_COLUMNS
      " FROM devices d CROSS JOIN chosen ON chosen.file = d.file CROSS JOIN files f ON f.id = d.file "
      "WHERE d.vendor_id = ? AND d.product_code = ? ORDER BY d.revision_no, chosen.rank, d.id");
  if (!query) return tl::unexpected(query.error());
  std::vector<CatalogueEntry> entries;
  query->bind(0, vendor_id).bind(1, product_code);
  if (auto status = query->each([&] { entries.push_back(entry_of(*query)); }); !status)
    return tl::unexpected(status.error());
  for (auto& entry : entries) {
    if (auto status = mark_hidden(store, entry); !status) return tl::unexpected(status.error());
  }
  if (auto status = compare_contents(store, entries); !status) return tl::unexpected(status.error());
  return entries;
}

Result<std::vector<CatalogueEntry>> search(CatalogueStore& store, const CatalogueSearch& search) {
  const auto wanted = revision_words(trim(search.words));
  Picker picker(store, search, wanted);
  const auto& words = wanted.words;
  if (!is_utf8(words)) return std::vector<CatalogueEntry>{};
  if (auto status = offer_types(store, words, picker); !status) return tl::unexpected(status.error());
  const auto expression = match_expression(words);
  if (!expression.empty() && !picker.full()) {
    const auto most = wanted.none() ? kMostByWords : kMostWithRevision;
    if (auto status = offer_words(store, expression, most, picker); !status) return tl::unexpected(status.error());
  }
  return picker.take();
}

Result<std::vector<DuplicateDevice>> duplicates(CatalogueStore& store, const std::function<bool()>& go_on) {
  // Without a product code (parts that are no slaves of their own) nothing is described twice.
  auto query = store.database().prepare(
      "SELECT d.vendor_id, d.product_code, d.revision_no FROM devices d CROSS JOIN chosen ON chosen.file = d.file "
      "WHERE d.product_code <> 0 GROUP BY d.vendor_id, d.product_code, d.revision_no HAVING count(*) > 1 "
      "ORDER BY d.vendor_id, d.product_code, d.revision_no");
  if (!query) return tl::unexpected(query.error());
  std::vector<DuplicateDevice> found;
  const auto number = [&](int column) { return static_cast<std::uint32_t>(query->integer(column)); };
  if (auto status = query->each([&] {
        found.push_back({.identity = {number(0), number(1), number(2), 0}});
      });
      !status) {
    return tl::unexpected(status.error());
  }
  // All revisions of a product come with one question.
  std::vector<CatalogueEntry> of_product;
  for (auto& duplicate : found) {
    if (go_on && !go_on()) return std::vector<DuplicateDevice>{};
    const Identity& wanted = duplicate.identity;
    const bool known = !of_product.empty() && of_product.front().identity.vendor_id == wanted.vendor_id &&
                       of_product.front().identity.product_code == wanted.product_code;
    if (!known) {
      auto entries = entries_of(store, wanted.vendor_id, wanted.product_code);
      if (!entries) return tl::unexpected(entries.error());
      of_product = std::move(*entries);
    }
    const auto revision = [](const CatalogueEntry& entry) { return entry.identity.revision_no; };
    // Not std::ranges::equal_range: clang 14 cannot compile what libstdc++ 12 makes of it.
    duplicate.entries.assign(std::ranges::lower_bound(of_product, wanted.revision_no, {}, revision),
                             std::ranges::upper_bound(of_product, wanted.revision_no, {}, revision));
    const auto& all = duplicate.entries;
    duplicate.conflict =
        std::ranges::any_of(all, [&](const auto& entry) { return entry.content != all.front().content; });
  }
  return found;
}

}  // namespace syncline::eni
