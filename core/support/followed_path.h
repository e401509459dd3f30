// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace syncline {

/// Where a path leads through symbolic links, also those whose end is not there yet.
struct FollowedPath {
  std::string file;      // the last link's
  bool in_proc = false;  // /dev/stdout and its like: an open file of a program, whatever that is
};
[[nodiscard]] FollowedPath follow_links(std::string file);

/// "." for a name alone.
[[nodiscard]] std::string folder_of(const std::string& file);

}  // namespace syncline
