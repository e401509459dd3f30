// SPDX-License-Identifier: Apache-2.0
#include "capture/pcapng_writer.h"

#include <utility>

#include "support/pcapng_block.h"

namespace syncline {

PcapngWriter::PcapngWriter(OutputFile out) : out_(std::move(out)) {
  append_pcapng_section(block_, {});
  append_pcapng_interface(block_, {}, {});
  (void)write_block();  // an error stays until the next one asks
}

Result<PcapngWriter> PcapngWriter::create(const std::string& path) {
  auto out = OutputFile::create(path);
  if (!out) return tl::unexpected(out.error());
  return PcapngWriter(std::move(*out));
}

Status PcapngWriter::write(std::span<const std::uint8_t> frame, Nanoseconds time, Direction direction) {
  append_pcapng_packet(block_,
                       {.time = time, .direction = static_cast<std::uint8_t>(direction), .notes = {}, .bytes = frame});
  return write_block();
}

Status PcapngWriter::write_block() {
  auto status = out_.write({reinterpret_cast<const char*>(block_.data()), block_.size()});
  block_.clear();
  return status;
}

}  // namespace syncline
