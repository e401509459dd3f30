// SPDX-License-Identifier: Apache-2.0
#include "sqlite/torn_database.h"

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <optional>
#include <utility>

namespace syncline {
namespace {

constexpr std::size_t kHeader = 100;  // of the file, in its first page
constexpr unsigned char kTableLeaf = 0x0D;
constexpr std::size_t kLogHeader = 32, kFrameHeader = 24;
/// A page is of one long row, and perhaps of some that lay there before; where bytes are damaged any row may lead
/// anywhere.
constexpr std::uint64_t kMostRowsOfAPage = 4;
/// More columns has no table; what says so is no row.
constexpr std::size_t kMostColumns = 64;

std::uint64_t big_endian(const unsigned char* bytes, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | bytes[i];
  return value;
}
std::uint32_t word(const unsigned char* bytes) { return static_cast<std::uint32_t>(big_endian(bytes, 4)); }

/// Takes SQLite's variable-length numbers off the front: seven bits a byte, highest first, eight of the ninth.
class Cursor {
 public:
  Cursor(const unsigned char* at, std::size_t size) : at_(at), end_(at + size) {}
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  [[nodiscard]] const unsigned char* at() const { return at_; }
  std::optional<std::uint64_t> number() {
    std::uint64_t value = 0;
    for (int i = 0; i < 9 && at_ != end_; ++i) {
      const auto byte = *at_++;
      if (i == 8) return value << 8 | byte;
      value = value << 7 | (byte & 0x7F);
      if (byte < 0x80) return value;
    }
    return std::nullopt;
  }
  const unsigned char* take(std::size_t count) {
    if (left() < count) return nullptr;
    return std::exchange(at_, at_ + count);
  }

 private:
  const unsigned char *at_, *end_;
};

/// Bytes of a value of this serial type.
std::optional<std::uint64_t> size_of(std::uint64_t type) {
  constexpr std::array<std::uint8_t, 10> kSizes{0, 1, 2, 3, 4, 6, 8, 8, 0, 0};
  if (type < kSizes.size()) return kSizes[type];
  if (type < 12) return std::nullopt;
  return (type - 12) / 2;
}

TornValue value_of(std::uint64_t type, const unsigned char* bytes, std::size_t size) {
  using Kind = TornValue::Kind;
  if (type == 0) return {};
  if (type == 8 || type == 9) return {.kind = Kind::kInteger, .integer = static_cast<std::int64_t>(type - 8)};
  if (type == 7) return {.kind = Kind::kReal, .real = std::bit_cast<double>(big_endian(bytes, 8))};
  if (type < 7) {
    const auto shift = 64 - 8 * static_cast<int>(size);
    return {.kind = Kind::kInteger, .integer = static_cast<std::int64_t>(big_endian(bytes, size) << shift) >> shift};
  }
  return {.kind = type % 2 == 0 ? Kind::kBlob : Kind::kText, .bytes = {reinterpret_cast<const char*>(bytes), size}};
}

bool read_at(std::ifstream& file, std::uint64_t place, unsigned char* out, std::size_t size) {
  file.clear();
  file.seekg(static_cast<std::streamoff>(place));
  file.read(reinterpret_cast<char*>(out), static_cast<std::streamsize>(size));
  return file.gcount() > 0;
}

bool is_page_size(std::uint32_t size) { return size >= 512 && size <= 65'536 && std::has_single_bit(size); }

}  // namespace

Result<TornDatabase> TornDatabase::open(const std::string& path) {
  TornDatabase torn;
  std::error_code error;
  torn.bytes_ = std::filesystem::file_size(path, error);
  if (!error) torn.file_.open(path, std::ios::binary);
  if (error || !torn.file_.is_open() || !torn.read_header())
    return fail(Error{.code = ErrorCode::kFileNotReadable, .file = path});
  torn.read_log(path + "-wal");
  torn.find_free_pages();
  return torn;
}

bool TornDatabase::read_header() {
  std::array<unsigned char, kHeader> header{};
  if (bytes_ < kHeader || !read_at(file_, 0, header.data(), kHeader)) return false;
  page_size_ = static_cast<std::uint32_t>(big_endian(&header[16], 2));
  if (page_size_ == 1) page_size_ = 65'536;
  if (!is_page_size(page_size_) || header[20] > page_size_ - 480) return false;
  usable_ = page_size_ - header[20];
  // Written with what last changed the file: else by a program that kept no account of it.
  if (word(&header[24]) == word(&header[92])) pages_said_ = word(&header[28]);
  first_free_ = word(&header[32]);
  user_version_ = word(&header[60]);
  application_id_ = word(&header[68]);
  pages_ = static_cast<std::uint32_t>(std::min<std::uint64_t>((bytes_ + page_size_ - 1) / page_size_, UINT32_MAX));
  return true;
}

std::uint64_t TornDatabase::bytes_said() const { return std::uint64_t{pages_said_} * page_size_; }

void TornDatabase::read_log(const std::string& path) {
  std::array<unsigned char, kLogHeader> header{};
  log_.open(path, std::ios::binary);
  if (!log_.is_open() || !read_at(log_, 0, header.data(), kLogHeader)) return;
  if (word(&header[8]) != page_size_) return;
  Places pending;
  std::array<unsigned char, kFrameHeader> frame{};
  for (std::uint64_t at = kLogHeader;; at += kFrameHeader + page_size_) {
    if (!read_at(log_, at, frame.data(), kFrameHeader) || log_.gcount() < static_cast<std::streamsize>(kFrameHeader))
      return;
    // Of an earlier round of the log, which was overwritten up to here.
    if (!std::equal(&frame[8], &frame[16], &header[16])) return;
    pending[word(frame.data())] = at + kFrameHeader;
    if (word(&frame[4]) == 0) continue;
    for (const auto& [number, place] : pending) {
      in_log_[number] = place;
      pages_ = std::max(pages_, number);
    }
    pending.clear();
  }
}

bool TornDatabase::read_page(std::uint32_t number, Page& page) {
  page.assign(page_size_, 0);
  if (number == 0) return false;
  if (const auto found = in_log_.find(number); found != in_log_.end())
    return read_at(log_, found->second, page.data(), page_size_);
  const auto place = std::uint64_t{number - 1} * page_size_;
  return place < bytes_ && read_at(file_, place, page.data(), page_size_);
}

void TornDatabase::find_free_pages() {
  Page page;
  for (auto trunk = first_free_; trunk != 0 && read_page(trunk, page) && free_.insert(trunk).second;) {
    const auto count = std::min<std::size_t>(word(&page[4]), usable_ / 4 - 2);
    for (std::size_t i = 0; i < count; ++i) free_.insert(word(&page[8 + 4 * i]));
    trunk = word(page.data());
  }
}

void TornDatabase::rows(const std::function<bool(std::int64_t id, std::span<const TornValue> row)>& take) {
  Page page;
  std::vector<TornValue> row;
  chained_ = 0;
  for (std::uint32_t number = 1; number <= pages_ && number != 0; ++number) {
    if (free_.contains(number) || !read_page(number, page)) continue;
    const std::size_t begin = number == 1 ? kHeader : 0;
    if (page[begin] != kTableLeaf) continue;
    const auto cells = static_cast<std::size_t>(big_endian(&page[begin + 3], 2));
    for (std::size_t cell = 0; cell < cells && begin + 10 + 2 * cell <= usable_; ++cell) {
      const auto at = static_cast<std::size_t>(big_endian(&page[begin + 8 + 2 * cell], 2));
      std::int64_t id = 0;
      if (at != 0 && at < usable_ && read_row(page, at, id, row) && !take(id, row)) return;
    }
  }
}

bool TornDatabase::read_row(const Page& page, std::size_t at, std::int64_t& id, std::vector<TornValue>& row) {
  Cursor cell(&page[at], usable_ - at);
  const auto size = cell.number();
  const auto key = cell.number();
  if (!size || !key || *size == 0 || *size > std::uint64_t{pages_} * page_size_) return false;
  id = static_cast<std::int64_t>(*key);
  if (!read_payload(page, usable_ - cell.left(), *size)) return false;
  Cursor types(reinterpret_cast<const unsigned char*>(payload_.data()), payload_.size());
  const auto header = types.number();
  if (!header || *header > payload_.size() || *header == 0) return false;
  const auto* const values_at = reinterpret_cast<const unsigned char*>(payload_.data()) + *header;
  Cursor values(values_at, payload_.size() - *header);
  row.clear();
  while (types.at() < values_at) {
    const auto type = types.number();
    const auto bytes = type ? size_of(*type) : std::nullopt;
    const auto* const value = bytes ? values.take(*bytes) : nullptr;
    if (value == nullptr || row.size() == kMostColumns) return false;
    row.push_back(value_of(*type, value, *bytes));
  }
  return types.at() == values_at && values.left() == 0;
}

/// What does not fit in its page goes on in a chain of others; how much fits, the format says.
bool TornDatabase::read_payload(const Page& page, std::size_t at, std::uint64_t size) {
  const std::uint64_t most = usable_ - 35;
  const std::uint64_t least = (usable_ - 12) * 32 / 255 - 23;
  const auto kept = least + (size - least) % (usable_ - 4);
  const auto here = size <= most ? size : kept <= most ? kept : least;
  if (at + here + (here < size ? 4 : 0) > usable_) return false;
  payload_.assign(reinterpret_cast<const char*>(&page[at]), here);
  auto next = here < size ? word(&page[at + here]) : 0;
  while (payload_.size() < size) {
    if (++chained_ > kMostRowsOfAPage * pages_ || !read_page(next, overflow_)) return false;
    const auto rest = std::min<std::uint64_t>(size - payload_.size(), usable_ - 4);
    payload_.append(reinterpret_cast<const char*>(&overflow_[4]), rest);
    next = word(overflow_.data());
  }
  return true;
}

}  // namespace syncline
