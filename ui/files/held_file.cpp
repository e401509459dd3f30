// SPDX-License-Identifier: Apache-2.0
#include "ui/files/held_file.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "reasons/because.h"
#include "sqlite/database_files.h"
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
    // What SQLite keeps beside a recording is as much of it.
    const auto files = database_files(held->path().toStdString());
    if (std::ranges::none_of(files, [&](const std::string& one) { return is_same_file(file, one); })) continue;
    return fail(Error{.code = ErrorCode::kFileNotWritable,
                      .detail = because("it is {what}, which would be lost: choose another name", held->what()),
                      .file = file});
  }
  return {};
}

}  // namespace syncline::ui
