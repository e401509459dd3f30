// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/catalogue_store.h"

#include <fmt/format.h>

#include <bit>
#include <cstdlib>

#include "eni/catalogue/catalogue_schema.h"
#include "eni/catalogue/esi_cards.h"
#include "eni/xml/xml_text.h"
#include "findings/value_bytes.h"

namespace syncline::eni {
namespace {

std::int64_t stored(std::uint64_t hash) { return std::bit_cast<std::int64_t>(hash); }

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// "EL2004" as "2004": users remember the number.
std::string numbers_of(std::string_view type) {
  std::string parts;
  for (std::size_t i = 1; i < type.size(); ++i) {
    if (!is_digit(type[i]) || !is_letter(type[i - 1])) continue;
    std::size_t end = i;
    while (end < type.size() && (is_digit(type[end]) || is_letter(type[end]))) ++end;
    parts.append(" ").append(type.substr(i, end - i));
  }
  return parts;
}

/// Product codes behind an x, so that no digit of a type finds them.
std::string search_text(const EsiCard& card) {
  return fmt::format("{} {} {} {} {} {} x{:x}", card.type, card.name, card.vendor_name, card.group_type,
                     card.group_name, numbers_of(card.type), card.identity.product_code);
}

/// As recordings keep reasons: the sentence, and the words for the languages of whoever reads it.
std::string words_of(Reason reason) {
  ValueWriter out;
  out(WordedReason{reason});
  return out.take();
}

Reason kept_reason(std::string_view sentence, std::string_view words) {
  auto reason = Reason::phrase(sentence);
  WordedReason worded{reason};
  ValueReader{words}(worded);
  return reason;
}

IndexedFile file_row(const SqlStatement& row, int first) {
  return {row.integer(first), row.integer(first + 1), row.integer(first + 2),
          std::bit_cast<std::uint64_t>(row.integer(first + 3))};
}

/// Paths below a folder are those from "folder/" up to "folder0": '0' is the character behind '/'.
std::pair<std::string, std::string> bounds_of(std::string_view folder) {
  std::string from(folder);
  if (!from.ends_with('/')) from += '/';
  std::string to = from;
  to.back() = '0';
  return {from, to};
}

}  // namespace

Result<CatalogueStore> CatalogueStore::open(const std::string& path, Reason& replaced) {
  auto database = open_catalogue_database(path, replaced);
  if (!database) return tl::unexpected(database.error());
  return CatalogueStore(std::move(*database));
}

Result<std::optional<IndexedFile>> CatalogueStore::file(std::string_view path) {
  auto query = database_.prepare("SELECT id, size, changed_ns, content FROM files WHERE path = ?");
  if (!query) return tl::unexpected(query.error());
  std::optional<IndexedFile> found;
  if (auto status = query->bind(0, path).each([&] { found = file_row(*query, 0); }); !status) {
    return tl::unexpected(status.error());
  }
  return found;
}

Status CatalogueStore::clear(std::int64_t file) {
  for (const std::string_view sql : {"DELETE FROM words WHERE rowid IN (SELECT id FROM devices WHERE file = ?)",
                                     "DELETE FROM hides WHERE device IN (SELECT id FROM devices WHERE file = ?)",
                                     "DELETE FROM devices WHERE file = ?", "DELETE FROM problems WHERE file = ?"}) {
    auto query = database_.prepare(sql);
    if (!query) return tl::unexpected(query.error());
    if (auto status = query->bind(0, file).run(); !status) return status;
  }
  return {};
}

Result<std::int64_t> CatalogueStore::put(std::string_view path, const IndexedFile& file, const EsiCards& cards) {
  auto insert = database_.prepare(
      "INSERT INTO files(path, size, changed_ns, content) VALUES(?, ?, ?, ?) ON CONFLICT(path) DO UPDATE SET "
      "size = excluded.size, changed_ns = excluded.changed_ns, content = excluded.content RETURNING id");
  if (!insert) return tl::unexpected(insert.error());
  insert->bind(0, path).bind(1, file.size).bind(2, file.changed_ns).bind(3, stored(file.content));
  std::int64_t id = 0;
  if (auto status = insert->each([&] { id = insert->integer(0); }); !status) return tl::unexpected(status.error());
  if (auto status = clear(id); !status) return tl::unexpected(status.error());
  for (const auto& card : cards.cards) {
    if (auto status = put_device(id, card); !status) return tl::unexpected(status.error());
  }
  for (const auto& warning : cards.warnings) {
    auto problem = database_.prepare("INSERT INTO problems VALUES(?, ?, ?, ?, ?)");
    if (!problem) return tl::unexpected(problem.error());
    const auto sentence = warning.reason.text(), words = words_of(warning.reason);
    problem->bind(0, id).bind(1, warning.line).bind(2, warning.element).bind(3, sentence).bind_blob(4, words);
    if (auto status = problem->run(); !status) return tl::unexpected(status.error());
  }
  return id;
}

Status CatalogueStore::put_device(std::int64_t file, const EsiCard& card) {
  auto insert = database_.prepare(
      "INSERT INTO devices(file, line, place, vendor_id, product_code, revision_no, vendor_name, type, name, "
      "group_type, group_name, "
      "physics, revision_rule, invisible) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  if (!insert) return tl::unexpected(insert.error());
  const Identity& identity = card.identity;
  insert->bind(0, file)
      .bind(1, card.line)
      .bind(2, card.place)
      .bind(3, identity.vendor_id)
      .bind(4, identity.product_code);
  insert->bind(5, identity.revision_no).bind(6, card.vendor_name).bind(7, card.type).bind(8, card.name);
  insert->bind(9, card.group_type).bind(10, card.group_name).bind(11, card.physics).bind(12, card.revision_rule);
  insert->bind(13, card.invisible);
  if (auto status = insert->run(); !status) return status;
  const auto device = database_.last_row();

  auto words = database_.prepare("INSERT INTO words(rowid, text) VALUES(?, ?)");
  if (!words) return tl::unexpected(words.error());
  if (auto status = words->bind(0, device).bind(1, search_text(card)).run(); !status) return status;

  for (const auto& hidden : card.hides) {
    auto hide = database_.prepare("INSERT INTO hides VALUES(?, ?, ?, ?)");
    if (!hide) return tl::unexpected(hide.error());
    hide->bind(0, device).bind(1, identity.vendor_id).bind(2, hidden.product_code);
    if (hidden.revision_no) hide->bind(3, *hidden.revision_no);
    if (auto status = hide->run(); !status) return status;
  }
  return {};
}

Status CatalogueStore::put_contents(std::string_view path, const std::vector<std::uint64_t>& contents) {
  const auto put_all = [&]() -> Status {
    for (std::size_t place = 0; place < contents.size(); ++place) {
      auto query = database_.prepare(
          "UPDATE devices SET content = ? WHERE place = ? AND file = (SELECT id FROM files WHERE path = ?)");
      if (!query) return tl::unexpected(query.error());
      query->bind(0, stored(contents[place])).bind(1, static_cast<std::int64_t>(place)).bind(2, path);
      if (auto status = query->run(); !status) return status;
    }
    return {};
  };
  // One transaction for all, whether or not there is one around it.
  if (auto status = database_.execute("SAVEPOINT contents"); !status) return status;
  auto status = put_all();
  if (status) return database_.execute("RELEASE contents");
  (void)database_.execute("ROLLBACK TO contents; RELEASE contents");
  return status;
}

Status CatalogueStore::touch(std::int64_t file, std::int64_t changed_ns) {
  auto query = database_.prepare("UPDATE files SET changed_ns = ? WHERE id = ?");
  if (!query) return tl::unexpected(query.error());
  return query->bind(0, changed_ns).bind(1, file).run();
}

Status CatalogueStore::remove(std::int64_t file) {
  if (auto status = clear(file); !status) return status;
  auto query = database_.prepare("DELETE FROM files WHERE id = ?");
  if (!query) return tl::unexpected(query.error());
  return query->bind(0, file).run();
}

Result<std::vector<std::pair<std::string, IndexedFile>>> CatalogueStore::files_below(std::string_view folder) {
  auto query = database_.prepare(
      "SELECT path, id, size, changed_ns, content FROM files WHERE path >= ? AND path < ? ORDER BY path");
  if (!query) return tl::unexpected(query.error());
  const auto [from, to] = bounds_of(folder);
  query->bind(0, from).bind(1, to);
  std::vector<std::pair<std::string, IndexedFile>> files;
  if (auto status = query->each([&] { files.emplace_back(query->text(0), file_row(*query, 1)); }); !status)
    return tl::unexpected(status.error());
  return files;
}

Result<std::vector<std::string>> CatalogueStore::folders() {
  auto query = database_.prepare("SELECT path FROM folders ORDER BY rowid");
  if (!query) return tl::unexpected(query.error());
  std::vector<std::string> found;
  if (auto status = query->each([&] { found.emplace_back(query->text(0)); }); !status)
    return tl::unexpected(status.error());
  return found;
}

Status CatalogueStore::remember_folder(std::string_view folder) {
  auto query = database_.prepare("INSERT OR IGNORE INTO folders VALUES(?)");
  if (!query) return tl::unexpected(query.error());
  return query->bind(0, folder).run();
}

Status CatalogueStore::forget_folder(std::string_view folder) {
  const auto files = files_below(folder);
  if (!files) return tl::unexpected(files.error());
  for (const auto& [path, file] : *files) {
    if (auto status = remove(file.id); !status) return status;
  }
  auto query = database_.prepare("DELETE FROM folders WHERE path = ?");
  if (!query) return tl::unexpected(query.error());
  return query->bind(0, folder).run();
}

Status CatalogueStore::choose(std::int64_t file) {
  auto query = database_.prepare("INSERT OR IGNORE INTO chosen(file) VALUES(?)");
  if (!query) return tl::unexpected(query.error());
  return query->bind(0, file).run();
}

Status CatalogueStore::check() {
  auto query = database_.prepare("PRAGMA integrity_check(1)");
  if (!query) return tl::unexpected(query.error());
  std::string found;
  if (auto status = query->each([&] { found = query->text(0); }); !status) return status;
  if (found != "ok") return damaged(database_, Reason::verbatim(found));
  return database_.execute("INSERT INTO words(words) VALUES('integrity-check')");
}

Result<std::size_t> CatalogueStore::device_count() {
  auto query = database_.prepare("SELECT count(*) FROM devices JOIN chosen USING(file)");
  if (!query) return tl::unexpected(query.error());
  std::size_t count = 0;
  if (auto status = query->each([&] { count = static_cast<std::size_t>(query->integer(0)); }); !status) {
    return tl::unexpected(status.error());
  }
  return count;
}

Result<std::vector<FileWarning>> CatalogueStore::problems() {
  auto query = database_.prepare(
      "SELECT path, line, element, text, words FROM chosen CROSS JOIN problems ON problems.file = chosen.file "
      "JOIN files ON files.id = problems.file ORDER BY chosen.rank, problems.rowid");
  if (!query) return tl::unexpected(query.error());
  std::vector<FileWarning> found;
  if (auto status = query->each([&] {
        found.push_back({std::string(query->text(0)), static_cast<int>(query->integer(1)), std::string(query->text(2)),
                         kept_reason(query->text(3), query->blob(4))});
      });
      !status)
    return tl::unexpected(status.error());
  return found;
}

std::string default_catalogue_path() {
  const auto variable = [](const char* name) {
    const char* const value = std::getenv(name);
    return std::string(value ? value : "");
  };
  std::string base = variable("XDG_CACHE_HOME");
  if (!base.starts_with('/')) {  // relative ones are to be ignored (XDG Base Directory Specification)
    const auto home = variable("HOME");
    if (home.empty()) return {};
    base = home + "/.cache";
  }
  return base + "/syncline/esi-catalogue.sqlite";
}

}  // namespace syncline::eni
