// SPDX-License-Identifier: Apache-2.0
#include "sqlite/row_check.h"

#include <libdeflate.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "support/byte_order.h"

namespace syncline {
namespace {

/// One value behind another, each with its type and length, so that no two rows read alike. Numbers and short texts are
/// gathered: the sum of many bytes at once costs less than that of a few at a time.
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
  [[nodiscard]] std::int64_t value() {
    sum_up();
    return static_cast<std::int64_t>(crc_);
  }

 private:
  void add_number(std::uint64_t number) {
    if (gathered_.size() - used_ < sizeof number) sum_up();
    store_le(std::span(gathered_).subspan(used_, sizeof number), number);
    used_ += sizeof number;
  }
  void add_bytes(const void* bytes, int size) {
    add_number(static_cast<std::uint64_t>(size));
    if (size <= 0) return;
    const std::span all(static_cast<const unsigned char*>(bytes), static_cast<std::size_t>(size));
    if (gathered_.size() - used_ < all.size()) sum_up();
    if (all.size() > gathered_.size()) {
      crc_ = ::libdeflate_crc32(crc_, all.data(), all.size());
      return;
    }
    std::ranges::copy(all, gathered_.begin() + static_cast<std::ptrdiff_t>(used_));
    used_ += all.size();
  }
  void sum_up() {
    crc_ = ::libdeflate_crc32(crc_, gathered_.data(), used_);
    used_ = 0;
  }

  alignas(8) std::array<unsigned char, 256> gathered_;  // not cleared: what is summed up was written
  std::size_t used_ = 0;
  std::uint32_t crc_ = 0;
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
