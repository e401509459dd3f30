// SPDX-License-Identifier: Apache-2.0
#include "capture/pcap_reader.h"

#include <fmt/format.h>
#include <pcap/pcap.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "reasons/because.h"
#include "support/byte_order.h"
#include "support/input_file.h"

namespace syncline {
namespace {

struct PcapCloser {
  void operator()(pcap_t* handle) const { pcap_close(handle); }  // closes the stream, too
};

}  // namespace

struct PcapReader::Impl {
  std::unique_ptr<pcap_t, PcapCloser> handle;
  std::string name;
};

PcapReader::PcapReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PcapReader::PcapReader(PcapReader&&) noexcept = default;
PcapReader& PcapReader::operator=(PcapReader&&) noexcept = default;
PcapReader::~PcapReader() = default;

Result<PcapReader> PcapReader::from_stream(void* stream, const std::string& name) {
  auto* file = static_cast<std::FILE*>(stream);
  char text[PCAP_ERRBUF_SIZE] = {};
  auto* handle = pcap_fopen_offline_with_tstamp_precision(file, PCAP_TSTAMP_PRECISION_NANO, text);
  if (handle == nullptr) {
    std::fclose(file);
    return fail(Error{ErrorCode::kNotThatKindOfFile, {}, because("a pcap or pcapng capture; {words}", text), name});
  }
  auto impl = std::make_unique<Impl>();
  impl->handle.reset(handle);
  impl->name = name;
  if (pcap_datalink(handle) != DLT_EN10MB) {
    const char* kind = pcap_datalink_val_to_name(pcap_datalink(handle));
    return fail(Error{ErrorCode::kNotThatKindOfFile,
                      {},
                      because("a capture of Ethernet frames; this one holds {reason}",
                              kind ? Reason::verbatim(kind) : because("something else")),
                      name});
  }
  return PcapReader(std::move(impl));
}

Result<PcapReader> PcapReader::open(const std::string& path) {
  auto input = InputFile::open(path);
  if (!input) return tl::unexpected(input.error());
  if (auto status = input->wait(); !status) return tl::unexpected(status.error());
  const int descriptor = input->release();
  auto* file = ::fdopen(descriptor, "rb");
  if (file == nullptr) {
    const auto why = Reason::of_system(errno);
    ::close(descriptor);
    return fail(Error{ErrorCode::kFileNotReadable, {}, why, path});
  }
  return from_stream(file, path);
}

Result<PcapReader> PcapReader::from_memory(std::span<const std::uint8_t> bytes, const std::string& name) {
  // fmemopen refuses size 0, and "rb" writes nothing into the buffer whatever its type says.
  if (bytes.empty())
    return fail(Error{ErrorCode::kNotThatKindOfFile, {}, because("a pcap or pcapng capture; it is empty"), name});
  auto* file = ::fmemopen(const_cast<std::uint8_t*>(bytes.data()), bytes.size(), "rb");
  if (file == nullptr) return fail(Error{ErrorCode::kFileNotReadable, {}, Reason::of_system(errno), name});
  return from_stream(file, name);
}

namespace {

/// What an EtherCAT Switch Link probe puts in front of a frame or behind it: a mark, flags (little endian, bit 13: its
/// time stamp is valid) and its time in ns.
constexpr std::size_t kProbeSize = 16;
constexpr std::uint16_t kProbeHasStamp = 0x2000;

bool is_probe_mark(std::span<const std::uint8_t> bytes) {
  return bytes[0] == 0x01 && bytes[1] == 0x01 && bytes[2] == 0x05 && (bytes[3] == 0x10 || bytes[3] == 0x11) &&
         bytes[4] == 0 && bytes[5] == 0;
}

void take_probe(CapturedFrame& frame) {
  if (frame.bytes.size() < kProbeSize || frame.truncated) return;
  const auto size = static_cast<std::ptrdiff_t>(kProbeSize);
  auto probe = frame.bytes.begin();
  if (!is_probe_mark({probe, probe + size})) probe = frame.bytes.end() - size;
  const std::span<const std::uint8_t> part(probe, probe + size);
  if (!is_probe_mark(part)) return;
  if ((load_le<std::uint16_t>(part.subspan(6, 2)) & kProbeHasStamp) != 0) {
    const auto stamp = load_le<std::uint64_t>(part.subspan(8, 8));
    if (stamp <= static_cast<std::uint64_t>(INT64_MAX)) frame.stamp = static_cast<Nanoseconds>(stamp);
  }
  frame.bytes.erase(probe, probe + size);
}

}  // namespace

std::uint64_t PcapReader::read_bytes() const {
  const auto at = std::ftell(pcap_file(impl_->handle.get()));
  return at > 0 ? static_cast<std::uint64_t>(at) : 0;
}

Result<std::optional<CapturedFrame>> PcapReader::next() {
  pcap_pkthdr* header = nullptr;
  const u_char* bytes = nullptr;
  const int found = pcap_next_ex(impl_->handle.get(), &header, &bytes);
  if (found == PCAP_ERROR_BREAK) return std::optional<CapturedFrame>{};
  if (found != 1) {
    return fail(Error{ErrorCode::kFileNotReadable, {}, Reason::phrase(pcap_geterr(impl_->handle.get())), impl_->name});
  }
  CapturedFrame frame;
  // The file decides about these: its seconds may be of 64 bits, and nanoseconds of 64 bits reach 292 years.
  Nanoseconds since_epoch = 0;
  Nanoseconds whole_seconds = 0;
  const Nanoseconds fraction = header->ts.tv_usec;  // asked for nanoseconds
  if (__builtin_sub_overflow(Nanoseconds{header->ts.tv_sec}, kDcEpochUnixSeconds, &since_epoch) ||
      __builtin_mul_overflow(since_epoch, kSecond, &whole_seconds) ||
      __builtin_add_overflow(whole_seconds, fraction, &frame.time)) {
    return fail(
        Error{ErrorCode::kFileNotReadable,
              {},
              because("a frame's time stamp of {time} s is outside of the years 1708 to 2292", header->ts.tv_sec),
              impl_->name});
  }
  frame.bytes.assign(bytes, bytes + header->caplen);
  frame.truncated = header->caplen < header->len;
  take_probe(frame);
  return frame;
}

}  // namespace syncline
