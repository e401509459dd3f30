// SPDX-License-Identifier: Apache-2.0
#include "ui/files/held_file.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "reasons/because.h"
#include "support/distinct_files.h"

namespace syncline::ui {
namespace {

std::vector<const HeldFile*>& all() {
  static std::vector<const HeldFile*> held;
  return held;
}

}  // namespace

HeldFile::HeldFile(Reason what) : what_(std::move(what)) { all().push_back(this); }

HeldFile::~HeldFile() { std::erase(all(), this); }

Status mayWrite(const QString& path, const HeldFile* own) {
  const auto file = path.toStdString();
  for (const auto* held : all()) {
    if (held == own || held->path().isEmpty()) continue;
    const auto of_held = held->path().toStdString();
    // What SQLite keeps beside a recording is as much of it.
    const bool same = is_same_file(file, of_held) || is_same_file(file, of_held + "-wal");
    if (!same) continue;
    return fail(Error{.code = ErrorCode::kFileNotWritable,
                      .detail = because("it is {what}, which would be lost: choose another name", held->what()),
                      .file = file});
  }
  return {};
}

}  // namespace syncline::ui
