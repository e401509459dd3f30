// SPDX-License-Identifier: Apache-2.0
#include "eni/xml/xml_limits.h"
#include "eni/xml/xml_text.h"
#include "support/whole_file.h"

namespace syncline::eni {

Result<std::string> read_file(const std::string& path) { return read_whole_file(path, kMaxFileBytes); }

Status write_file_atomic(const std::string& path, std::string_view content) { return write_whole_file(path, content); }

}  // namespace syncline::eni
