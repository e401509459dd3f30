// SPDX-License-Identifier: Apache-2.0
#include "ui/session/first_pictures.h"

#include <cstddef>
#include <iterator>
#include <utility>

#include "record/first_columns.h"

namespace syncline::ui {
namespace {

/// Those that show the same range are made in one pass over the blocks.
Status draw(RecordingReader& reader, std::vector<FirstPicture>& pictures, const std::set<std::size_t>& gaps) {
  std::vector<bool> done(pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto& first = pictures[i];
    std::vector<std::size_t> together;
    std::vector<Signal> signals;
    for (std::size_t k = i; k < pictures.size(); ++k) {
      const auto& one = pictures[k];
      if (done[k] || one.begin != first.begin || one.end != first.end || one.width != first.width) continue;
      done[k] = true;
      together.push_back(k);
      signals.insert(signals.end(), one.signals.begin(), one.signals.end());
    }
    if (together.empty()) continue;
    auto columns = first_columns(reader, signals, first.begin, first.end, first.width, gaps);
    if (!columns) return tl::unexpected(columns.error());
    auto next = std::move_iterator(columns->begin());
    for (const auto k : together) {
      const auto behind = next + static_cast<std::ptrdiff_t>(pictures[k].signals.size());
      pictures[k].columns.assign(next, behind);
      next = behind;
    }
  }
  return {};
}

}  // namespace

void FirstPictures::ask(std::vector<FirstPicture> pictures) {
  const std::lock_guard lock(mutex_);
  asked_ = std::move(pictures);
  any_ = true;
}

std::optional<std::vector<FirstPicture>> FirstPictures::answer(const std::string& path) {
  if (any_.exchange(false)) {
    const std::lock_guard lock(mutex_);
    answered_ = std::exchange(asked_, {});
  } else if (!renewed_ || answered_.empty()) {
    return std::nullopt;
  }
  renewed_ = false;
  answered_gaps_ = gaps_.size();
  auto pictures = answered_;
  // The reader of the samples is where it is.
  if (!reader_) {
    auto reader = RecordingReader::open(path);
    if (!reader) return std::nullopt;
    reader_.emplace(std::move(*reader));
  }
  const auto drawn = draw(*reader_, pictures, gaps_);
  return drawn ? std::optional(std::move(pictures)) : std::nullopt;
}

void FirstPictures::forget() {
  const std::lock_guard lock(mutex_);
  asked_.clear();
  any_ = false;
  reader_.reset();
  answered_.clear();
  gaps_.clear();
  answered_gaps_ = 0;
  renewed_ = false;
}

}  // namespace syncline::ui
