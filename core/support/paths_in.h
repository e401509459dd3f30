// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

namespace syncline {

/// What lies in a folder: FOLDER/NAME each, in the system's order, without "." and "..". `error` where it cannot be
/// read (to its end). std::bad_alloc where there is no memory: in std::filesystem::directory_iterator that ends the
/// program.
[[nodiscard]] std::vector<std::filesystem::path> paths_in(const std::filesystem::path& folder, std::error_code& error);

}  // namespace syncline
