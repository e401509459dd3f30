// SPDX-License-Identifier: Apache-2.0
#include "app/composition/capture_file.h"

#include <filesystem>
#include <utility>

#include "link/capture_tap.h"

namespace syncline {

Status capture_to(const std::string& file, OpenedLink& opened) {
  if (file.empty()) return {};
  auto tap = make_capture_tap(std::move(opened.link), file, *opened.clock);
  if (!tap) return tl::unexpected(tap.error());
  opened.link = std::move(*tap);
  return {};
}

Status capture_complete(const std::string& file) {
  // What could not be completed keeps its provisional name.
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file + ".part", error)) return {};
  return fail(Error{ErrorCode::kFileNotWritable, {}, "writing the capture failed; is the disk full?", file});
}

}  // namespace syncline
