// SPDX-License-Identifier: Apache-2.0
#include "config/compile/process_image.h"

#include <algorithm>

namespace syncline::compiler {
namespace {

/// Part of an area that one datagram carries.
struct Chunk {
  std::uint32_t first_byte = 0, end_byte = 0;  // offsets in the area
  std::uint16_t writing_slaves = 0, reading_slaves = 0;
};

class LogicalArea {
 public:
  LogicalArea(std::uint32_t start, std::uint16_t max_length) : start_(start), max_length_(max_length) {}

  /// Reserves room for a slave; both placements (either may be null) get the same address.
  void place(SlavePlan& slave, bool outputs, bool inputs, bool pack_bits) {
    const std::uint32_t out_bits = outputs ? slave.image_bits(PdoDirection::kRx) : 0;
    const std::uint32_t in_bits = inputs ? slave.image_bits(PdoDirection::kTx) : 0;
    const std::uint32_t bits = std::max(out_bits, in_bits);
    if (bits == 0) {
      return;
    }
    if (!pack_bits) {
      align();
    }
    if (chunks_.empty() || begin_chunk_ || (end_bit_ + bits + 7) / 8 - chunks_.back().first_byte > max_length_) {
      align();
      begin_chunk_ = false;
      chunks_.push_back({end_bit_ / 8, end_bit_ / 8, 0, 0});
    }
    Chunk& chunk = chunks_.back();
    const Placement at{0, start_ + end_bit_ / 8, static_cast<std::uint8_t>(end_bit_ % 8), chunks_.size() - 1};
    if (out_bits > 0) {
      slave.outputs = at;
      slave.outputs.bits = out_bits;
      ++chunk.writing_slaves;
    }
    if (in_bits > 0) {
      slave.inputs = at;
      slave.inputs.bits = in_bits;
      ++chunk.reading_slaves;
    }
    end_bit_ += bits;
    chunk.end_byte = (end_bit_ + 7) / 8;
  }

  /// The next slave starts a new datagram.
  void begin_chunk() { begin_chunk_ = true; }
  [[nodiscard]] bool has_writers(std::size_t chunk) const { return chunks_[chunk].writing_slaves > 0; }
  [[nodiscard]] bool has_readers(std::size_t chunk) const { return chunks_[chunk].reading_slaves > 0; }

  [[nodiscard]] LogicalDatagram datagram(std::size_t chunk_index, Command command) const {
    const Chunk& chunk = chunks_[chunk_index];
    const int writers = chunk.writing_slaves;
    const int readers = chunk.reading_slaves;
    const int wkc = command == Command::kLrw ? 2 * writers + readers : command == Command::kLwr ? writers : readers;
    return {command, start_ + chunk.first_byte, static_cast<std::uint16_t>(chunk.end_byte - chunk.first_byte),
            static_cast<std::uint16_t>(wkc)};
  }

  [[nodiscard]] std::size_t chunk_count() const { return chunks_.size(); }
  [[nodiscard]] std::uint32_t end_byte() const { return (end_bit_ + 7) / 8; }

 private:
  void align() { end_bit_ = (end_bit_ + 7) / 8 * 8; }

  std::uint32_t start_;
  std::uint16_t max_length_;
  std::uint32_t end_bit_ = 0;
  bool begin_chunk_ = false;
  std::vector<Chunk> chunks_;
};

bool has(const SlavePlan& slave, PdoDirection direction) { return slave.image_bits(direction) > 0; }

/// Commands that a chunk needs. EC-Engineer takes LRW for one direction, too.
std::vector<Command> commands_of(const LogicalArea& area, std::size_t chunk, bool lrw) {
  if (lrw) return {Command::kLrw};
  if (!area.has_readers(chunk)) return {Command::kLwr};
  if (!area.has_writers(chunk)) return {Command::kLrd};
  return {Command::kLwr, Command::kLrd};
}

ImageLayout one_area(std::span<SlavePlan> slaves, const ImageOptions& options) {
  LogicalArea area(kEcEngineerLogicalBase, options.max_length);
  std::size_t lrw_chunks = 0;
  // Slaves that cannot do LRW stand behind the others, in datagrams of their own.
  for (const bool lrw : {true, false}) {
    if (!lrw) area.begin_chunk();
    for (SlavePlan& slave : slaves) {
      if (slave.device().use_lrd_lwr != lrw) area.place(slave, true, options.overlap, false);
    }
    for (SlavePlan& slave : slaves) {
      if (!options.overlap && slave.device().use_lrd_lwr != lrw) area.place(slave, false, true, false);
    }
    if (lrw) lrw_chunks = area.chunk_count();
  }
  ImageLayout layout;
  std::vector<std::size_t> writing(area.chunk_count()), reading(area.chunk_count());
  for (std::size_t chunk = 0; chunk < area.chunk_count(); ++chunk) {
    for (const Command command : commands_of(area, chunk, chunk < lrw_chunks)) {
      if (command != Command::kLrd) writing[chunk] = layout.datagrams.size();
      if (command != Command::kLwr) reading[chunk] = layout.datagrams.size();
      layout.datagrams.push_back(area.datagram(chunk, command));
    }
  }
  for (SlavePlan& slave : slaves) {
    if (slave.outputs.bits > 0) slave.outputs.datagram = writing[slave.outputs.datagram];
    if (slave.inputs.bits > 0) slave.inputs.datagram = reading[slave.inputs.datagram];
  }
  return layout;
}

/// One of TwinCAT's areas: the slaves that `belongs` accepts, byte-oriented ones first.
template <class Belongs>
void add_area(ImageLayout& layout, std::span<SlavePlan> slaves, Command command, std::uint32_t& next_start,
              std::uint16_t max_length, Belongs belongs) {
  LogicalArea area(next_start, max_length);
  const std::size_t first_datagram = layout.datagrams.size();
  const bool outputs = command != Command::kLrd;
  const bool inputs = command != Command::kLwr;
  for (const bool bit_oriented : {false, true}) {
    for (SlavePlan& slave : slaves) {
      if (slave.bit_oriented == bit_oriented && belongs(slave)) {
        area.place(slave, outputs, inputs, bit_oriented);
        if (outputs) {
          slave.outputs.datagram += first_datagram;
        }
        if (inputs) {
          slave.inputs.datagram += first_datagram;
        }
      }
    }
  }
  for (std::size_t chunk = 0; chunk < area.chunk_count(); ++chunk) {
    layout.datagrams.push_back(area.datagram(chunk, command));
  }
  next_start += (area.end_byte() + kTwinCatAreaStep - 1) / kTwinCatAreaStep * kTwinCatAreaStep;
}

ImageLayout three_areas(std::span<SlavePlan> slaves, const ImageOptions& options) {
  const std::uint16_t max_length = options.max_length;
  const auto both = [&](const SlavePlan& s) {
    return options.overlap && has(s, PdoDirection::kRx) && has(s, PdoDirection::kTx) && !s.device().use_lrd_lwr;
  };
  ImageLayout layout;
  std::uint32_t next_start = kTwinCatLogicalBase;
  add_area(layout, slaves, Command::kLrw, next_start, max_length, both);
  add_area(layout, slaves, Command::kLwr, next_start, max_length,
           [&](const SlavePlan& s) { return has(s, PdoDirection::kRx) && !both(s); });
  add_area(layout, slaves, Command::kLrd, next_start, max_length,
           [&](const SlavePlan& s) { return has(s, PdoDirection::kTx) && !both(s); });
  return layout;
}

}  // namespace

ImageLayout layout_process_image(std::span<SlavePlan> slaves, const ImageOptions& options) {
  return options.dialect == EniDialect::kEcEngineer ? one_area(slaves, options) : three_areas(slaves, options);
}

}  // namespace syncline::compiler
