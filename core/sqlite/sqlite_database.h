// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "support/result.h"

struct sqlite3;
struct sqlite3_stmt;

/// SQLite without its C interface: values that close themselves, kCatalogue with SQLite's code and words.
namespace syncline {

/// A prepared statement. Parameters and columns count from 0. Texts of a row live until the next step().
class SqlStatement {
 public:
  explicit SqlStatement(sqlite3_stmt* statement) : statement_(statement) {}
  SqlStatement& bind(int parameter, std::int64_t value);
  SqlStatement& bind(int parameter, std::string_view text);
  SqlStatement& bind_real(int parameter, double value);
  /// Bytes that outlive the next step().
  SqlStatement& bind_blob(int parameter, std::string_view bytes);
  SqlStatement& bind_null(int parameter);
  /// True: there is a row to read. False: done.
  [[nodiscard]] Result<bool> step();
  /// For statements that give no rows: runs it and makes it ready for the next use.
  [[nodiscard]] Status run();
  /// Calls `take` for each row, until it returns false where it returns something; then ready for the next use.
  template <class Take>
  [[nodiscard]] Status each(Take&& take) {
    for (;;) {
      const auto row = step();
      bool more = row && *row;
      if (more) {
        if constexpr (std::is_void_v<decltype(take())>) {
          take();
        } else {
          more = take();
        }
      }
      if (more) continue;
      reset();
      return row ? Status{} : Status(tl::unexpected(row.error()));
    }
  }
  [[nodiscard]] std::int64_t integer(int column) const;
  [[nodiscard]] std::string_view text(int column) const;
  [[nodiscard]] double real(int column) const;
  /// Bytes of a BLOB or a text, whichever it is.
  [[nodiscard]] std::string_view blob(int column) const;
  [[nodiscard]] bool is_null(int column) const;
  void reset();

 private:
  sqlite3_stmt* statement_;
};

/// One connection; for one thread at a time.
class SqlDatabase {
 public:
  /// "" is a database in memory that ends with this object. kCatalogue; kFileNotWritable for a device or a folder.
  [[nodiscard]] static Result<SqlDatabase> open(const std::string& path);
  /// One that exists, to be looked at: what a killed program left in its log is read too.
  [[nodiscard]] static Result<SqlDatabase> open_to_read(const std::string& path);

  /// An empty one on the disk, where temporary files lie, that ends with this object; `path`: what it calls itself.
  [[nodiscard]] static Result<SqlDatabase> open_temporary(const std::string& path);

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Statements without parameters and rows, several separated by ";".
  [[nodiscard]] Status execute(const char* sql);
  /// The statement of this text, prepared once and reset. Besides SQLite's own functions it may call row_crc(), see
  /// core/sqlite/row_check.h.
  [[nodiscard]] Result<SqlStatement> prepare(std::string_view sql);
  /// The first column of the only row of this statement; 0 without a row. For pragmas and counts.
  [[nodiscard]] Result<std::int64_t> number(std::string_view sql);
  [[nodiscard]] std::int64_t last_row() const;

 private:
  static Result<SqlDatabase> open_with(const std::string& path, const char* file, int flags);
  struct Close {
    void operator()(sqlite3* database) const;
  };
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
  std::map<std::string, std::unique_ptr<sqlite3_stmt, Finalize>, std::less<>> statements_;  // gone before database_
};

/// True when the file is no database or a broken one: nothing in it can be trusted.
[[nodiscard]] bool is_damaged(const Error& error);
/// Such an error, with what was found.
[[nodiscard]] tl::unexpected<Error> damaged(const SqlDatabase& database, Reason detail);

/// BEGIN now, ROLLBACK at the end unless commit() came before.
class SqlTransaction {
 public:
  [[nodiscard]] static Result<SqlTransaction> begin(SqlDatabase& database);
  /// For reading: all that is read within is of one state of the file, and needs no lock of its own.
  [[nodiscard]] static Result<SqlTransaction> begin_reading(SqlDatabase& database);
  SqlTransaction(SqlTransaction&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
  SqlTransaction& operator=(SqlTransaction&&) = delete;
  ~SqlTransaction();
  [[nodiscard]] Status commit();

 private:
  explicit SqlTransaction(SqlDatabase& database) : database_(&database) {}
  SqlDatabase* database_;
};

}  // namespace syncline
