// SPDX-License-Identifier: Apache-2.0
#include "sim/mailbox/file_server.h"

#include <algorithm>
#include <utility>

namespace syncline::sim {
namespace {

/// All the memory that the device has for a file.
constexpr std::size_t kLargestFile = 1024 * 1024;
/// Of its flash; each is erased when the first byte behind it arrives, and the device is busy meanwhile.
constexpr std::size_t kSector = 64 * 1024;

}  // namespace

foe::Message FileServer::refuse(std::uint32_t code) {
  transfer_.reset();
  return foe::FileError{code, std::string(foe::error_text(code))};
}

std::optional<foe::Message> FileServer::respond(const foe::Message& message, std::size_t mailbox_size) {
  if (const auto* m = std::get_if<foe::ReadRequest>(&message)) return begin_read(*m, mailbox_size);
  if (const auto* m = std::get_if<foe::WriteRequest>(&message)) return begin_write(*m);
  if (const auto* m = std::get_if<foe::Data>(&message)) return take(*m, mailbox_size);
  if (const auto* m = std::get_if<foe::Ack>(&message)) return acknowledged(*m, mailbox_size);
  if (std::holds_alternative<foe::FileError>(message)) {  // the master gives up
    transfer_.reset();
    return std::nullopt;
  }
  return refuse(foe::error::kIllegal);
}

foe::Message FileServer::begin_read(const foe::ReadRequest& request, std::size_t mailbox_size) {
  if (password_ != 0 && request.password != password_) return refuse(foe::error::kAccessDenied);
  const auto found = files_.find(request.name);
  if (found == files_.end()) return refuse(foe::error::kNotFound);
  transfer_ = Transfer{request.name, found->second, 0, 0, false, false};
  return next_packet(mailbox_size);
}

foe::Message FileServer::begin_write(const foe::WriteRequest& request) {
  if (password_ != 0 && request.password != password_) return refuse(foe::error::kAccessDenied);
  if (request.name.empty()) return refuse(foe::error::kIllegal);
  transfer_ = Transfer{request.name, {}, 0, 0, true, false};
  return foe::Ack{0};
}

foe::Message FileServer::next_packet(std::size_t mailbox_size) {
  auto& t = *transfer_;
  const auto room = foe::data_capacity(mailbox_size);
  const auto count = std::min(room, t.bytes.size() - t.position);
  foe::Data packet{++t.packet_no, {}};
  const auto begin = t.bytes.begin() + static_cast<std::ptrdiff_t>(t.position);
  packet.bytes.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
  t.position += count;
  t.last_sent = count < room;
  return packet;
}

std::optional<foe::Message> FileServer::acknowledged(const foe::Ack& ack, std::size_t mailbox_size) {
  if (!transfer_ || transfer_->writing) return refuse(foe::error::kIllegal);
  if (ack.packet_no != transfer_->packet_no) return refuse(foe::error::kPacketNumber);
  if (!transfer_->last_sent) return next_packet(mailbox_size);
  transfer_.reset();
  return std::nullopt;
}

foe::Message FileServer::take(const foe::Data& data, std::size_t mailbox_size) {
  if (!transfer_ || !transfer_->writing) return refuse(foe::error::kIllegal);
  auto& t = *transfer_;
  if (data.packet_no != t.packet_no + 1) return refuse(foe::error::kPacketNumber);
  if (t.bytes.size() + data.bytes.size() > kLargestFile) return refuse(foe::error::kDiskFull);
  const bool next_sector = (t.bytes.size() + data.bytes.size()) / kSector > t.bytes.size() / kSector;
  if (next_sector && !std::exchange(t.erased, true))
    return foe::Busy{0, 0, "erasing"};  // the master repeats the packet
  t.erased = false;
  t.packet_no = data.packet_no;
  t.bytes.insert(t.bytes.end(), data.bytes.begin(), data.bytes.end());
  if (data.bytes.size() < foe::data_capacity(mailbox_size)) {
    files_[t.name] = std::move(t.bytes);
    transfer_.reset();
  }
  return foe::Ack{data.packet_no};
}

}  // namespace syncline::sim
