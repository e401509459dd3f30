// SPDX-License-Identifier: Apache-2.0
#include "eni/esi_catalogue.h"

#include <algorithm>
#include <filesystem>

#include "protocol/error_text.h"

namespace syncline::eni {

Status EsiCatalogue::add_folder(const std::string& path) {
  std::error_code error;
  std::vector<std::string> files;
  for (std::filesystem::directory_iterator it(path, error), end; !error && it != end; it.increment(error)) {
    auto extension = it->path().extension().string();
    std::ranges::transform(extension, extension.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
    if (extension == ".xml" && !it->is_directory()) files.push_back(it->path().string());
  }
  if (error) {
    const bool missing = error == std::errc::no_such_file_or_directory;
    return fail(Error{.code = missing ? ErrorCode::kFileNotFound : ErrorCode::kFileNotReadable,
                      .detail = error.message(),
                      .file = path});
  }
  std::ranges::sort(files);  // the same folder gives the same catalogue on every machine
  for (const auto& file : files) {
    if (const auto status = add_file(file); !status) {
      const Error& problem = status.error();
      warnings_.push_back({file, problem.line, problem.subject, describe(problem)});
    }
  }
  return {};
}

Status EsiCatalogue::add_file(const std::string& path) {
  auto file = read_esi(path);
  if (!file) return tl::unexpected(file.error());
  std::ranges::move(file->devices, std::back_inserter(devices_));
  std::ranges::move(file->warnings, std::back_inserter(warnings_));
  return {};
}

std::optional<DeviceMatch> EsiCatalogue::find(const Identity& identity) const {
  const DeviceDescription* newest = nullptr;
  const DeviceDescription* newest_not_newer = nullptr;
  const auto improves = [](const DeviceDescription& device, const DeviceDescription* best) {
    return best == nullptr || device.identity.revision_no > best->identity.revision_no;
  };
  for (const auto& device : devices_) {
    const Identity& known = device.identity;
    if (known.vendor_id != identity.vendor_id || known.product_code != identity.product_code) continue;
    if (identity.revision_no != 0 && known.revision_no == identity.revision_no) return DeviceMatch{&device, true};
    if (improves(device, newest)) newest = &device;
    if (known.revision_no < identity.revision_no && improves(device, newest_not_newer)) newest_not_newer = &device;
  }
  const bool any_revision = identity.revision_no == 0;
  const auto* best = !any_revision && newest_not_newer ? newest_not_newer : newest;
  if (best == nullptr) return std::nullopt;
  return DeviceMatch{best, any_revision};
}

}  // namespace syncline::eni
