// SPDX-License-Identifier: Apache-2.0
#include "ui/session/first_pictures.h"

#include <utility>

#include "record/first_columns.h"

namespace syncline::ui {

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
  for (auto& picture : pictures) {
    auto columns = first_columns(*reader_, picture.signals, picture.begin, picture.end, picture.width, gaps_);
    if (!columns) return std::nullopt;
    picture.columns = std::move(*columns);
  }
  return pictures;
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
