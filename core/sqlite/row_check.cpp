// SPDX-License-Identifier: Apache-2.0
#include "sqlite/row_check.h"

#include <sqlite3.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace syncline {
namespace {

/// One value behind another, each with its type and length, so that no two rows read alike.
class Check {
 public:
  void add(sqlite3_value* value) {
    const int type = sqlite3_value_type(value);
    add_number(static_cast<std::uint64_t>(type));
    switch (type) {
      case SQLITE_INTEGER:
        return add_number(static_cast<std::uint64_t>(sqlite3_value_int64(value)));
      case SQLITE_FLOAT:
        // SQLite keeps whole numbers as integers, which know no negative zero.
        return add_number(std::bit_cast<std::uint64_t>(sqlite3_value_double(value) + 0.0));
      case SQLITE_TEXT: {
        const auto* const text = sqlite3_value_text(value);
        return add_bytes(text, sqlite3_value_bytes(value));
      }
      case SQLITE_BLOB: {
        const auto* const blob = sqlite3_value_blob(value);
        return add_bytes(blob, sqlite3_value_bytes(value));
      }
      default:
        return;
    }
  }
  [[nodiscard]] std::int64_t value() const { return static_cast<std::int64_t>(crc_); }

 private:
  void add_number(std::uint64_t number) {
    std::array<unsigned char, 8> bytes{};
    for (auto& byte : bytes) {
      byte = static_cast<unsigned char>(number);
      number >>= 8;
    }
    crc_ = ::crc32_z(crc_, bytes.data(), bytes.size());
  }
  void add_bytes(const void* bytes, int size) {
    add_number(static_cast<std::uint64_t>(size));
    if (size > 0) crc_ = ::crc32_z(crc_, static_cast<const unsigned char*>(bytes), static_cast<std::size_t>(size));
  }

  unsigned long crc_ = 0;
};

void row_crc(sqlite3_context* context, int count, sqlite3_value** values) {
  Check check;
  for (int i = 0; i < count; ++i) check.add(values[i]);
  sqlite3_result_int64(context, check.value());
}

}  // namespace

int add_row_crc(sqlite3* database) {
  return sqlite3_create_function_v2(database, "row_crc", -1, SQLITE_UTF8 | SQLITE_DETERMINISTIC, nullptr, row_crc,
                                    nullptr, nullptr, nullptr);
}

}  // namespace syncline
