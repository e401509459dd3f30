// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "support/result.h"

/// The rows of a file that SQLite gives no more, because it is cut off or one of its own pages is damaged: found page
/// by page by the file format (sqlite.org/fileformat2.html), whatever is lost of what leads to them.
namespace syncline {

/// A value as it lies in a row.
struct TornValue {
  enum class Kind : std::uint8_t { kNull, kInteger, kReal, kText, kBlob };
  Kind kind = Kind::kNull;
  std::int64_t integer = 0;
  double real = 0;
  std::string_view bytes{};  // of texts and BLOBs; until the next row
};

/// A file with its log, if there is one: what was committed last of each page. For one thread.
class TornDatabase {
 public:
  /// kFileNotReadable: it cannot be opened, or its first bytes are those of no database.
  [[nodiscard]] static Result<TornDatabase> open(const std::string& path);

  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }  // that are there, without the log
  /// That there were when the file was last written, as its first page says; 0: it does not.
  [[nodiscard]] std::uint64_t bytes_said() const;
  [[nodiscard]] std::uint32_t application_id() const { return application_id_; }
  [[nodiscard]] std::uint32_t user_version() const { return user_version_; }

  /// Each row of any table whose bytes are all there, by its page; what they are worth, who knows the tables must say.
  /// A column that is the table's INTEGER PRIMARY KEY is kNull, its value is `id`. Until `take` returns false. Time
  /// grows with the file, whatever is in it: when as many pages of long rows were read as no file of this size has, the
  /// other long rows are taken for none.
  void rows(const std::function<bool(std::int64_t id, std::span<const TornValue> row)>& take);

 private:
  using Page = std::vector<unsigned char>;
  /// Where a page lies that the log holds.
  using Places = std::map<std::uint32_t, std::uint64_t>;

  bool read_header();
  void read_log(const std::string& path);
  /// What is not there is zero. False: nothing of it is there.
  bool read_page(std::uint32_t number, Page& page);
  void find_free_pages();
  bool read_row(const Page& page, std::size_t at, std::int64_t& id, std::vector<TornValue>& row);
  bool read_payload(const Page& page, std::size_t at, std::uint64_t size);

  std::ifstream file_, log_;
  std::uint64_t bytes_ = 0;
  std::uint32_t page_size_ = 0, usable_ = 0, pages_ = 0, pages_said_ = 0;
  std::uint32_t application_id_ = 0, user_version_ = 0, first_free_ = 0;
  Places in_log_;
  std::set<std::uint32_t> free_;
  std::uint64_t chained_ = 0;  // pages that were read for long rows
  std::string payload_;
  Page overflow_;
};

}  // namespace syncline
