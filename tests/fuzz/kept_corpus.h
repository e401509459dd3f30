// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fuzz/damage.h"

/// Inputs that libFuzzer has found to reach something that no other one reaches, kept beside the sources: a file for
/// each target below tests/fuzz/corpus, in which each input stands behind its length (32 bit, little endian).
namespace syncline::fuzz {

inline constexpr std::size_t kMostKept = 20 * 1024;  // bytes of a target

/// Empty where nothing is kept, or what lies there is no such file.
[[nodiscard]] std::vector<Bytes> kept_corpus(const std::string& target);
/// Keeps the files of a folder instead, the shortest first, as many as kMostKept takes; where none is so short all
/// stays as it is. False when it cannot be written.
[[nodiscard]] bool keep_corpus(const std::string& target, const std::filesystem::path& folder);

}  // namespace syncline::fuzz
