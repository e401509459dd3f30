// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "master/exchange/slave_batch.h"
#include "master/sii/sii_port.h"
#include "reasons/because.h"

namespace syncline {

/// The end of a failed write's reason when nothing of it is left.
inline constexpr std::string_view kOldContentIsBack = reason_words("; the old content was put back");

/// Reads or writes words of one slave's EEPROM, taken from the PDI and given back. A write happens as a whole or not at
/// all: words that are right already are left alone, each other one is read back, the configuration area (words 0 to 7)
/// comes last and must end up with its checksum; when a word fails, or somebody cancels, those before it are put back,
/// newest first. Allocates where what is read has no room in the caller's bytes.
class SiiWork final : public SlaveWork {
 public:
  /// What is there comes behind what `into` holds, which outlives the work.
  void read(const SlaveAddress& slave, std::uint32_t word, std::uint32_t words, std::vector<std::uint8_t>& into);
  /// Both outlive the work; `before` takes what was there, room for the data and 24 bytes. `any_checksum`: of somebody
  /// who knows what he writes.
  void write(const SlaveAddress& slave, std::uint32_t word, std::span<const std::uint8_t> data,
             std::vector<std::uint8_t>& before, bool any_checksum = false);
  /// Told of the words that have been written and read back; may be empty.
  void set_progress(std::function<void(std::size_t done)> progress) { progress_ = std::move(progress); }
  /// A read ends; a write that has begun puts back first.
  void cancel();
  /// Ends it now: nobody answers any more.
  void give_up(const BriefError& why);

  Datagram* next(Nanoseconds now) override;
  void take(Nanoseconds now) override;
  [[nodiscard]] bool over() const override { return step_ == Step::kOver; }
  [[nodiscard]] Status result() const override;
  [[nodiscard]] Nanoseconds not_before() const override { return port_.not_before(); }
  /// kSii with the word, kBadValue for a configuration area with a wrong checksum, kCancelled.
  [[nodiscard]] const std::optional<BriefError>& failure() const { return failure_; }
  /// Words that were different and have been written.
  [[nodiscard]] std::size_t written() const { return written_; }

 private:
  enum class Step : std::uint8_t { kOver, kOpen, kRead, kBefore, kWrite, kReadBack, kUndo, kUndone, kProof, kClose };

  void begin(const SlaveAddress& slave);
  void go_on();
  void step_done();
  void take_before();
  void write_next();
  void undo_next();
  void take_failure();
  void refuse(const BriefError& why);
  void close(Step = Step::kClose);
  [[nodiscard]] std::uint32_t place(std::size_t n) const;
  [[nodiscard]] std::uint16_t wanted(std::uint32_t word) const;
  [[nodiscard]] std::uint16_t found(std::uint32_t word) const;
  [[nodiscard]] bool checksum_holds();

  SiiPort port_;
  Step step_ = Step::kOver;
  std::function<void(std::size_t)> progress_;
  bool cancelled_ = false, undoing_ = false, any_checksum_ = false;
  std::uint32_t word_ = 0;                     // first one that is read or written
  std::vector<std::uint8_t>* into_ = nullptr;  // reads
  std::size_t begin_ = 0, bytes_ = 0;          // where in it, how many
  std::span<const std::uint8_t> data_;         // writes
  std::vector<std::uint8_t>* before_ = nullptr;
  std::uint32_t before_word_ = 0, next_word_ = 0;
  std::size_t index_ = 0;  // of the word in the order of writing
  std::size_t written_ = 0, left_ = 0;
  int undo_tries_ = 0;
  std::optional<BriefError> failure_;
};

}  // namespace syncline
