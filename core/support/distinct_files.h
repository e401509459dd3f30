// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "support/result.h"

namespace syncline {

/// A file, and what the user calls it: "--csv", "file", "--link sim:m.toml".
struct NamedFile {
  std::string what, path;
};

/// Whether what is written to one of these paths is lost in the other: one file by its device and number, through
/// links of both kinds, or, where it is not there yet, one name in one folder. Never of what takes no harm: terminals,
/// pipes, /dev/null, /dev/stdout, and what is no path ("").
[[nodiscard]] bool is_same_file(const std::string& one, const std::string& other);

/// The rule of whoever writes files: none of them is one that is read for it, and no two are one. To be asked before
/// anything is opened for writing. kBadValue with both names; the first pair that is found. What is "" is not asked
/// for.
[[nodiscard]] Status check_distinct(std::span<const NamedFile> read, std::span<const NamedFile> written);

}  // namespace syncline
