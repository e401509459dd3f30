// SPDX-License-Identifier: Apache-2.0
#include "record/frame_segments.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "reasons/because.h"
#include "support/followed_path.h"
#include "support/paths_in.h"
#include "support/pcapng_block.h"

namespace syncline {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExtension = ".pcapng";
/// Behind the program's name in each section header: without it a file is none of ours, and never deleted.
constexpr std::string_view kMark = " (Syncline black box)";
constexpr std::size_t kMarkWithin = 512;        // bytes from the begin of a file
constexpr std::size_t kGathered = 1U << 18;     // bytes, then the system gets them
constexpr std::uint64_t kLastBlock = 1U << 12;  // room for the statistics at a file's end
constexpr std::size_t kLongestName =
    200;  // of program, interface and description: the mark is found, blocks stay small

Error not_writable(const std::string& file, Reason why) {
  return Error{.code = ErrorCode::kFileNotWritable, .detail = std::move(why), .file = file};
}

/// A folder's name means files in it, a capture's name what stands before its extension.
std::string base_name(std::string name) {
  std::error_code error;
  if (name.ends_with(kExtension)) name.resize(name.size() - kExtension.size());
  if (name.empty() || name.ends_with('/') || fs::is_directory(name, error))
    return (fs::path(name) / "black-box").string();
  return name;
}

std::string utc_digits(Nanoseconds time) {
  const std::time_t seconds = time / kSecond + kDcEpochUnixSeconds;
  std::tm utc{};
  ::gmtime_r(&seconds, &utc);
  return fmt::format("{:04}{:02}{:02}{:02}{:02}{:02}", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday, utc.tm_hour,
                     utc.tm_min, utc.tm_sec);
}

bool all_digits(std::string_view text) {
  return std::ranges::all_of(text, [](char letter) { return letter >= '0' && letter <= '9'; });
}

/// The number in NAME_00001_20260131235959.pcapng.
std::optional<std::uint64_t> number_of(std::string_view file, std::string_view base) {
  constexpr std::size_t kLeastDigits = 5, kTimeDigits = 14;
  if (!file.starts_with(base) || !file.ends_with(kExtension)) return std::nullopt;
  file.remove_prefix(base.size());
  file.remove_suffix(kExtension.size());
  if (file.size() < kLeastDigits + kTimeDigits + 2 || file.front() != '_') return std::nullopt;
  const auto time = file.substr(file.size() - kTimeDigits);
  const auto digits = file.substr(1, file.size() - kTimeDigits - 2);
  if (file[file.size() - kTimeDigits - 1] != '_' || !all_digits(time) || !all_digits(digits)) return std::nullopt;
  std::uint64_t number = 0;
  const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return failed == std::errc() ? std::optional(number) : std::nullopt;
}

enum class Whose : std::uint8_t { kOurs, kForeign, kInWork };

/// An empty one is ours, too: killed before its first block.
Whose whose(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return Whose::kForeign;
  std::array<char, kMarkWithin> begin{};
  const auto count = ::read(descriptor, begin.data(), begin.size());
  const bool free = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  if (count < 0) return Whose::kForeign;
  const std::string_view text(begin.data(), static_cast<std::size_t>(count));
  if (count > 0 && text.find(kMark) == std::string_view::npos) return Whose::kForeign;
  return free ? Whose::kOurs : Whose::kInWork;
}

/// errno, 0 when all is written.
int write_all(int descriptor, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const auto written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return EIO;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

FrameSegments::FrameSegments(Options options) : options_(std::move(options)) {
  options_.name = base_name(options_.name);
  options_.most_bytes = std::max(options_.most_bytes, kLeastBytes);
  for (auto* text : {&options_.program, &options_.interface, &options_.description})
    text->resize(std::min(text->size(), kLongestName));
}

FrameSegments::~FrameSegments() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Status FrameSegments::begin() {
  const auto folder = folder_of(options_.name);
  struct stat found {};
  if (::stat(folder.c_str(), &found) != 0) return fail(not_writable(options_.name, Reason::of_system(errno)));
  if (!S_ISDIR(found.st_mode)) return fail(not_writable(options_.name, Reason::of_system(ENOTDIR)));
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return fail(not_writable(options_.name, Reason::of_system(errno)));
  const auto base = fs::path(options_.name).filename().string();
  std::error_code error;
  for (const auto& there : paths_in(folder, error)) {
    const auto number = number_of(there.filename().string(), base);
    std::error_code none;
    if (!number || !fs::is_regular_file(there, none)) continue;
    next_number_ = std::max(next_number_, *number + 1);
    const auto path = there.string();
    const auto of = whose(path);
    if (of == Whose::kInWork)
      return fail(not_writable(path, because("another program writes to a black box of this name: use another one")));
    if (of == Whose::kOurs) segments_.push_back({.path = path, .number = *number, .bytes = fs::file_size(there, none)});
  }
  if (error) return fail(not_writable(options_.name, Reason::of_system(error.value())));
  std::ranges::sort(segments_, {}, &Segment::number);
  const auto space = fs::space(folder, error);
  const auto needed = options_.most_bytes + options_.keep_free_bytes;
  if (!error && space.available + bytes() < needed) {
    return fail(not_writable(
        options_.name, because("the disk has {left} MiB left, a black box needs {needed} MiB with what is kept free",
                               space.available >> 20, needed >> 20)));
  }
  return {};
}

std::uint64_t FrameSegments::bytes() const {
  std::uint64_t sum = 0;
  for (const auto& segment : segments_) sum += segment.bytes;
  return sum;
}

Status FrameSegments::remove_oldest() {
  const auto& path = segments_.front().path;
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return fail(not_writable(path, Reason::of_system(errno)));
  segments_.pop_front();
  return {};
}

Status FrameSegments::open(Nanoseconds time) {
  while (!segments_.empty() && bytes() + segment_bytes() > options_.most_bytes) {
    if (auto status = remove_oldest(); !status) return status;
  }
  const auto path = fmt::format("{}_{:05}_{}{}", options_.name, next_number_, utc_digits(time), kExtension);
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) return fail(not_writable(path, Reason::of_system(errno)));
  (void)::flock(descriptor_, LOCK_EX | LOCK_NB);
  segments_.push_back({.path = path, .number = next_number_++, .begin = time});
  given_ = 0;
  append_pcapng_section(gathered_, options_.program + std::string(kMark));
  append_pcapng_interface(gathered_, options_.interface, options_.description);
  return {};
}

Status FrameSegments::add(const PcapngPacket& packet) {
  if (descriptor_ < 0) {
    if (auto status = open(packet.time); !status) return status;
  }
  const auto before = gathered_.size();
  append_pcapng_packet(gathered_, packet);
  if (given_ + gathered_.size() + kLastBlock > segment_bytes() && segments_.back().frames > 0) {
    gathered_.resize(before);
    if (auto status = close({}, 0); !status) return status;
    return add(packet);
  }
  auto& segment = segments_.back();
  ++segment.frames;
  segment.lost += packet.lost_before;
  segment.end = packet.time;
  segment.bytes = given_ + gathered_.size();
  return gathered_.size() < kGathered ? Status{} : write();
}

Status FrameSegments::flush() {
  if (descriptor_ < 0) return {};
  if (auto status = write(); !status) return status;
  return check_disk();
}

Status FrameSegments::write() {
  auto& segment = segments_.back();
  const int number = write_all(descriptor_, gathered_);
  if (number == 0) given_ += gathered_.size();
  gathered_.clear();
  if (number != 0) {
    (void)!::ftruncate(descriptor_, static_cast<off_t>(given_));  // what came of a block
    segment.bytes = given_;
    return fail(not_writable(segment.path, Reason::of_system(number)));
  }
  if (!options_.sync || std::chrono::steady_clock::now() - synced_ < std::chrono::seconds(1)) return {};
  synced_ = std::chrono::steady_clock::now();
  return ::fdatasync(descriptor_) == 0 ? Status{} : fail(not_writable(segment.path, Reason::of_system(errno)));
}

Status FrameSegments::check_disk() const {
  const auto& path = segments_.back().path;
  struct stat named {
  }, ours{};
  if (::stat(path.c_str(), &named) != 0 || ::fstat(descriptor_, &ours) != 0 || named.st_ino != ours.st_ino ||
      named.st_dev != ours.st_dev) {
    return fail(
        not_writable(path, because("the file is gone: it, or its folder, was deleted or moved while it was written")));
  }
  std::error_code error;
  const auto space = fs::space(folder_of(path), error);
  if (error || space.available >= options_.keep_free_bytes) return {};
  return fail(not_writable(
      path, because("only {left} MiB are left on the disk; the black box is whole up to here", space.available >> 20)));
}

Status FrameSegments::close(std::span<const std::string> notes, std::uint64_t lost) {
  auto& segment = segments_.back();
  segment.lost += lost;
  append_pcapng_statistics(gathered_, {.begin = segment.begin,
                                       .end = segment.end,
                                       .received = segment.frames + segment.lost,
                                       .lost = segment.lost,
                                       .notes = notes});
  auto status = flush();
  segment.bytes = given_;
  if (options_.sync) (void)::fdatasync(descriptor_);
  ::close(std::exchange(descriptor_, -1));
  return status;
}

Status FrameSegments::finish(std::span<const std::string> notes, std::uint64_t lost) {
  if (descriptor_ < 0) return {};
  std::size_t count = 0, size = 0;
  constexpr std::size_t kFields = 128;
  while (count < notes.size() && (size += notes[count].size() + 8) + kFields <= kLastBlock) ++count;
  return close(notes.first(count), lost);
}

}  // namespace syncline
