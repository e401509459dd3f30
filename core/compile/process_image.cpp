// SPDX-License-Identifier: Apache-2.0
#include "compile/process_image.h"

#include <algorithm>

#include "compile/slave_plan.h"

namespace syncline::compiler {
namespace {

/// Part of an area that one datagram carries.
struct Chunk {
  std::uint32_t first_byte = 0, end_byte = 0;  // offsets in the area
  std::uint16_t writing_slaves = 0, reading_slaves = 0;
  std::size_t task = 0;
  bool lrw = true;
};

class LogicalArea {
 public:
  LogicalArea(std::uint32_t start, const ImageOptions& options)
      : start_(start),
        max_length_(options.max_length),
        alignment_bits_(std::max<std::uint8_t>(options.alignment, 1) * 8U) {}

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
      chunks_.push_back({end_bit_ / 8, end_bit_ / 8, 0, 0, task_, lrw_});
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

  /// The next slave starts a new datagram, of that task; without `lrw` it holds slaves that cannot do LRW.
  void begin_chunk(std::size_t task, bool lrw) {
    begin_chunk_ = true;
    task_ = task;
    lrw_ = lrw;
  }
  [[nodiscard]] bool lrw(std::size_t chunk) const { return chunks_[chunk].lrw; }
  [[nodiscard]] bool has_writers(std::size_t chunk) const { return chunks_[chunk].writing_slaves > 0; }
  [[nodiscard]] bool has_readers(std::size_t chunk) const { return chunks_[chunk].reading_slaves > 0; }

  [[nodiscard]] LogicalDatagram datagram(std::size_t chunk_index, Command command) const {
    const Chunk& chunk = chunks_[chunk_index];
    const int writers = chunk.writing_slaves;
    const int readers = chunk.reading_slaves;
    const int wkc = command == Command::kLrw ? 2 * writers + readers : command == Command::kLwr ? writers : readers;
    return {command, start_ + chunk.first_byte, static_cast<std::uint16_t>(chunk.end_byte - chunk.first_byte),
            static_cast<std::uint16_t>(wkc), chunk.task};
  }

  [[nodiscard]] std::size_t chunk_count() const { return chunks_.size(); }
  [[nodiscard]] std::uint32_t end_byte() const { return (end_bit_ + 7) / 8; }

 private:
  void align() { end_bit_ = (end_bit_ + alignment_bits_ - 1) / alignment_bits_ * alignment_bits_; }

  std::uint32_t start_;
  std::uint16_t max_length_;
  std::uint32_t alignment_bits_;
  std::uint32_t end_bit_ = 0;
  bool begin_chunk_ = false;
  std::size_t task_ = 0;
  bool lrw_ = true;
  std::vector<Chunk> chunks_;
};

/// Commands that a chunk needs. EC-Engineer takes LRW for one direction, too.
std::vector<Command> commands_of(const LogicalArea& area, std::size_t chunk) {
  if (area.lrw(chunk)) return {Command::kLrw};
  if (!area.has_readers(chunk)) return {Command::kLwr};
  if (!area.has_writers(chunk)) return {Command::kLrd};
  return {Command::kLwr, Command::kLrd};
}

/// The slaves of one Sync Unit, those with LRW or those without. Where directions lie apart, outputs stand first.
void place_unit(LogicalArea& area, std::span<SlavePlan> slaves, std::size_t unit, bool lrw, bool overlap) {
  for (const bool second_pass : {false, true}) {
    for (SlavePlan& slave : slaves) {
      if (slave.device().use_lrd_lwr == lrw) continue;
      const bool outputs = slave.output_unit == unit, inputs = slave.input_unit == unit;
      if (overlap) {
        if (!second_pass) area.place(slave, outputs, inputs, false);
      } else if (second_pass) {
        area.place(slave, false, inputs, false);
      } else {
        area.place(slave, outputs, false, false);
      }
    }
  }
}

ImageLayout one_area(std::span<SlavePlan> slaves, const ImageOptions& options) {
  LogicalArea area(options.logical_base(), options);
  for (std::size_t unit = 0; unit < options.unit_tasks.size(); ++unit) {
    // Slaves that cannot do LRW stand behind the others, in datagrams of their own.
    for (const bool lrw : {true, false}) {
      area.begin_chunk(options.unit_tasks[unit], lrw);
      place_unit(area, slaves, unit, lrw, options.overlap);
    }
  }
  ImageLayout layout;
  std::vector<std::size_t> writing(area.chunk_count()), reading(area.chunk_count());
  for (std::size_t chunk = 0; chunk < area.chunk_count(); ++chunk) {
    for (const Command command : commands_of(area, chunk)) {
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

/// TwinCAT's areas of one Sync Unit, one behind the other.
class UnitAreas {
 public:
  UnitAreas(ImageLayout& layout, std::span<SlavePlan> slaves, const ImageOptions& options)
      : layout_(layout), slaves_(slaves), options_(options), next_start_(options.logical_base()) {}

  void add(std::size_t unit) {
    unit_ = unit;
    const auto both = [this](const SlavePlan& s) {
      return options_.overlap && writes(s) && reads(s) && !s.device().use_lrd_lwr;
    };
    add_area(Command::kLrw, both);
    add_area(Command::kLwr, [&](const SlavePlan& s) { return writes(s) && !both(s); });
    add_area(Command::kLrd, [&](const SlavePlan& s) { return reads(s) && !both(s); });
  }

 private:
  [[nodiscard]] bool writes(const SlavePlan& s) const {
    return s.output_unit == unit_ && s.image_bits(PdoDirection::kRx) > 0;
  }
  [[nodiscard]] bool reads(const SlavePlan& s) const {
    return s.input_unit == unit_ && s.image_bits(PdoDirection::kTx) > 0;
  }

  /// The slaves that `belongs` accepts, byte-oriented ones first.
  template <class Belongs>
  void add_area(Command command, Belongs belongs) {
    LogicalArea area(next_start_, options_);
    area.begin_chunk(options_.unit_tasks[unit_], command == Command::kLrw);
    const std::size_t first_datagram = layout_.datagrams.size();
    const bool outputs = command != Command::kLrd;
    const bool inputs = command != Command::kLwr;
    for (const bool bit_oriented : {false, true}) {
      for (SlavePlan& slave : slaves_) {
        if (slave.bit_oriented != bit_oriented || !belongs(slave)) continue;
        area.place(slave, outputs, inputs, bit_oriented);
        if (outputs) slave.outputs.datagram += first_datagram;
        if (inputs) slave.inputs.datagram += first_datagram;
      }
    }
    for (std::size_t chunk = 0; chunk < area.chunk_count(); ++chunk) {
      layout_.datagrams.push_back(area.datagram(chunk, command));
    }
    next_start_ += (area.end_byte() + kTwinCatAreaStep - 1) / kTwinCatAreaStep * kTwinCatAreaStep;
  }

  ImageLayout& layout_;
  std::span<SlavePlan> slaves_;
  const ImageOptions& options_;
  std::uint32_t next_start_;
  std::size_t unit_ = 0;
};

ImageLayout three_areas(std::span<SlavePlan> slaves, const ImageOptions& options) {
  ImageLayout layout;
  UnitAreas areas(layout, slaves, options);
  for (std::size_t unit = 0; unit < options.unit_tasks.size(); ++unit) areas.add(unit);
  return layout;
}

}  // namespace

ImageLayout layout_process_image(std::span<SlavePlan> slaves, const ImageOptions& options) {
  return options.dialect == EniDialect::kEcEngineer ? one_area(slaves, options) : three_areas(slaves, options);
}

}  // namespace syncline::compiler
