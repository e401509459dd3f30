// SPDX-License-Identifier: Apache-2.0
#include "master/sii/sii_work.h"

#include <algorithm>
#include <array>

#include "master/sii/sii_layout.h"
#include "protocol/sii.h"
#include "reasons/brief_reason.h"
#include "support/byte_order.h"

namespace syncline {
namespace {

constexpr std::size_t kChecksummed = 14;  // bytes, the checksum behind them
constexpr int kUndoTries = 3;
constexpr auto kNotPutBack =
    reason_words("; not all words could be put back: write them again before power is switched off");

}  // namespace

void SiiWork::begin(const SlaveAddress& slave) {
  port_.use(slave);
  port_.open();
  step_ = Step::kOpen;
  cancelled_ = undoing_ = false;
  index_ = written_ = left_ = 0;
  failure_.reset();
}

void SiiWork::read(const SlaveAddress& slave, std::uint32_t word, std::uint32_t words,
                   std::vector<std::uint8_t>& into) {
  begin(slave);
  word_ = next_word_ = word;
  into_ = &into;
  begin_ = into.size();
  bytes_ = 2 * std::size_t{words};
  before_ = nullptr;
}

void SiiWork::write(const SlaveAddress& slave, std::uint32_t word, std::span<const std::uint8_t> data,
                    std::vector<std::uint8_t>& before, bool any_checksum) {
  begin(slave);
  word_ = word;
  into_ = nullptr;
  data_ = data;
  any_checksum_ = any_checksum;
  before_ = &before;
  before.clear();
  // What the checksum covers is read with it.
  before_word_ = next_word_ = word < kSiiConfigurationWords ? 0 : word;
  const auto end =
      std::max<std::size_t>(word + data.size() / 2, word < kSiiConfigurationWords ? kSiiConfigurationWords : 0);
  bytes_ = 2 * (end - before_word_);
}

void SiiWork::cancel() { cancelled_ = !over(); }

void SiiWork::give_up(const BriefError& why) {
  step_ = Step::kOver;
  failure_ = why;
  if (before_ != nullptr && written_ > 0) failure_->why.word = kNotPutBack;
}

Status SiiWork::result() const {
  if (!failure_) return {};
  return fail(failure_->about("slave"));
}

Datagram* SiiWork::next(Nanoseconds now) {
  if (over()) return nullptr;
  return port_.next(now);
}

void SiiWork::take(Nanoseconds now) {
  if (over()) return;
  port_.take(now);
  go_on();
}

void SiiWork::go_on() {
  while (!over() && port_.over()) {
    if (port_.failure()) {
      take_failure();
    } else if (cancelled_ && !undoing_ && step_ != Step::kProof && step_ != Step::kClose) {
      refuse({.code = ErrorCode::kCancelled});
    } else {
      step_done();
    }
  }
}

/// Of the word at hand, or of the interface itself.
void SiiWork::take_failure() {
  switch (step_) {
    case Step::kUndo:  // the word may hold what it held all the same
      step_ = Step::kUndone;
      return port_.read(place(index_));
    case Step::kUndone:
      return undo_next();  // once more, or the next one
    case Step::kClose:
      step_ = Step::kOver;
      if (!failure_) failure_ = port_.failure();
      return;
    case Step::kWrite:
    case Step::kReadBack:
      return refuse(*port_.failure());
    default:
      failure_ = port_.failure();
      return close();
  }
}

void SiiWork::step_done() {
  switch (step_) {
    case Step::kOver:
      return;
    case Step::kOpen:
      step_ = into_ != nullptr ? Step::kRead : Step::kBefore;
      return port_.read(next_word_);
    case Step::kRead: {
      const auto got = into_->size() - begin_;
      const auto piece = port_.piece().first(std::min<std::size_t>(SiiPort::kPiece, bytes_ - got));
      into_->insert(into_->end(), piece.begin(), piece.end());
      next_word_ += SiiPort::kPiece / 2;
      if (got + piece.size() == bytes_) return close();
      return port_.read(next_word_);
    }
    case Step::kBefore:
      return take_before();
    case Step::kWrite:
      step_ = Step::kReadBack;
      return port_.read(place(index_));
    case Step::kReadBack: {
      const auto at = place(index_);
      const auto reads = load_le<std::uint16_t>(port_.piece());
      if (reads != wanted(at)) {
        return refuse({.code = ErrorCode::kSii,
                       .why = brief("word 0x{word} reads 0x{value} after another value was written{which}",
                                    hex_number(at, 4), hex_number(reads, 4))});
      }
      ++index_;
      if (progress_) progress_(written_);
      return write_next();
    }
    case Step::kUndo:
      step_ = Step::kUndone;
      return port_.read(place(index_));
    case Step::kUndone: {
      const auto at = place(index_);
      if (load_le<std::uint16_t>(port_.piece()) != found(at)) return undo_next();
      undo_tries_ = kUndoTries;  // it is back
      left_ -= 1;
      return undo_next();
    }
    case Step::kProof: {
      const auto at = next_word_ - word_;
      const auto part = data_.subspan(2 * at, std::min<std::size_t>(SiiPort::kPiece, data_.size() - 2 * at));
      if (!std::ranges::equal(part, port_.piece().first(part.size()))) {
        failure_ = {.code = ErrorCode::kSii,
                    .why = brief("the content changed again after every word had been verified, at word 0x{word}",
                                 hex_number(next_word_, 4))};
        return close();
      }
      next_word_ += SiiPort::kPiece / 2;
      if (2 * std::size_t{next_word_ - word_} >= data_.size()) return close();
      return port_.read(next_word_);
    }
    case Step::kClose:
      step_ = Step::kOver;
      return;
  }
}

void SiiWork::close(Step step) {
  step_ = step;
  port_.close();
}

/// Words in the order of writing: those of the configuration area last.
std::uint32_t SiiWork::place(std::size_t n) const {
  const auto count = data_.size() / 2;
  const auto area = word_ < kSiiConfigurationWords ? std::min<std::size_t>(kSiiConfigurationWords - word_, count) : 0;
  const auto at = n < count - area ? n + area : n - (count - area);
  return word_ + static_cast<std::uint32_t>(at);
}

std::uint16_t SiiWork::wanted(std::uint32_t word) const {
  return load_le<std::uint16_t>(data_.subspan(2 * std::size_t{word - word_}));
}

std::uint16_t SiiWork::found(std::uint32_t word) const {
  return load_le<std::uint16_t>(std::span<const std::uint8_t>(*before_).subspan(2 * std::size_t{word - before_word_}));
}

bool SiiWork::checksum_holds() {
  if (word_ >= kSiiConfigurationWords || any_checksum_) return true;
  std::array<std::uint8_t, 2 * kSiiConfigurationWords> area{};
  std::copy_n(before_->begin(), area.size(), area.begin());
  const auto at = 2 * std::size_t{word_};
  std::copy_n(data_.begin(), std::min(data_.size(), area.size() - at), area.begin() + static_cast<std::ptrdiff_t>(at));
  const auto right = sii::checksum(std::span<const std::uint8_t>(area).first(kChecksummed));
  if (area[kChecksummed] == right) return true;
  failure_ = {
      .code = ErrorCode::kBadValue,
      .why =
          brief("words 0 to 7 would end up with the checksum 0x{has} where 0x{right} is right; write word 7 with them",
                hex_number(area[kChecksummed], 2), hex_number(right, 2))};
  return false;
}

void SiiWork::take_before() {
  const auto piece = port_.piece().first(std::min<std::size_t>(SiiPort::kPiece, bytes_ - before_->size()));
  before_->insert(before_->end(), piece.begin(), piece.end());
  next_word_ += SiiPort::kPiece / 2;
  if (before_->size() < bytes_) return port_.read(next_word_);
  if (!checksum_holds()) return close();
  write_next();
}

void SiiWork::write_next() {
  const auto count = data_.size() / 2;
  while (index_ < count && wanted(place(index_)) == found(place(index_))) ++index_;
  if (index_ == count) {
    if (written_ == 0) return close();
    step_ = Step::kProof;
    next_word_ = word_;
    return port_.read(next_word_);
  }
  ++written_;
  step_ = Step::kWrite;
  port_.write(place(index_), wanted(place(index_)));
}

/// Back to what it was; this is not cancelled.
void SiiWork::refuse(const BriefError& why) {
  failure_ = why;
  if (before_ == nullptr || written_ == 0) return close();
  undoing_ = true;
  left_ = written_;
  if (index_ < data_.size() / 2) ++index_;  // the word at hand may have been stored
  undo_tries_ = kUndoTries;
  undo_next();
}

/// The word at hand again, or the one that was written before it.
void SiiWork::undo_next() {
  if (++undo_tries_ > kUndoTries) {
    undo_tries_ = 1;
    do {
      if (index_ == 0) {
        failure_->why.word = left_ == 0 ? kOldContentIsBack : kNotPutBack;
        return close();
      }
      --index_;
    } while (wanted(place(index_)) == found(place(index_)));
  }
  step_ = Step::kUndo;
  port_.write(place(index_), found(place(index_)));
}

}  // namespace syncline
