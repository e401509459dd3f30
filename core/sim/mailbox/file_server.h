// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocol/foe.h"

namespace syncline::sim {

/// FoE server of a slave: small files in its memory, read and written one at a time (ETG.1000.6, 5.8).
class FileServer {
 public:
  /// 0: every password opens.
  explicit FileServer(std::uint32_t password) : password_(password) {}

  /// Answers one message; nothing where the protocol has none. `mailbox_size`: of the send mailbox.
  std::optional<foe::Message> respond(const foe::Message& message, std::size_t mailbox_size);
  /// A transfer under way ends unfinished.
  void reset() { transfer_.reset(); }

  [[nodiscard]] const std::map<std::string, std::vector<std::uint8_t>>& files() const { return files_; }
  void put(const std::string& name, std::vector<std::uint8_t> content) { files_[name] = std::move(content); }

 private:
  struct Transfer {
    std::string name;
    std::vector<std::uint8_t> bytes;
    std::size_t position = 0;
    std::uint32_t packet_no = 0;
    bool writing = false;
    bool last_sent = false;
    bool erased = false;  // the sector that the next packet begins
  };
  foe::Message begin_read(const foe::ReadRequest& request, std::size_t mailbox_size);
  foe::Message begin_write(const foe::WriteRequest& request);
  std::optional<foe::Message> acknowledged(const foe::Ack& ack, std::size_t mailbox_size);
  foe::Message take(const foe::Data& data, std::size_t mailbox_size);
  foe::Message next_packet(std::size_t mailbox_size);
  foe::Message refuse(std::uint32_t code);

  std::uint32_t password_;
  std::map<std::string, std::vector<std::uint8_t>> files_;
  std::optional<Transfer> transfer_;
};

}  // namespace syncline::sim
