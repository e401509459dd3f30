// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/usual_sources.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "eni/catalogue/esi_catalogue.h"
#include "reasons/because.h"

namespace syncline::eni {

std::vector<std::string> usual_sources(const EsiCatalogue& catalogue, std::vector<std::string> own) {
  auto sources = catalogue.known_folders().value_or(std::vector<std::string>{});
  // One that nobody may look at stays, so that this is told.
  std::erase_if(sources, [](const std::string& source) {
    std::error_code error;
    return !std::filesystem::exists(source, error) && !error;
  });
  std::move(own.begin(), own.end(), std::back_inserter(sources));
  return sources;
}

Result<IndexReport> add_source(EsiCatalogue& catalogue, const std::string& path, const IndexCallback& callback) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return catalogue.add_folder(path, callback);
  if (auto status = catalogue.add_file(path); !status) return tl::unexpected(status.error());
  return IndexReport{.files = 1, .read = 1};
}

std::vector<Error> unreadable_folders(const IndexReport& report) {
  std::vector<Error> errors;
  for (const auto& folder : report.unreadable)
    errors.push_back(
        {.code = ErrorCode::kFileNotReadable, .detail = because("its ESI files are missing here"), .file = folder});
  return errors;
}

std::vector<Error> add_usual_sources(EsiCatalogue& catalogue, std::vector<std::string> own,
                                     const IndexCallback& callback) {
  std::vector<Error> errors;
  for (const auto& source : usual_sources(catalogue, std::move(own))) {
    const auto report = add_source(catalogue, source, callback);
    if (!report) {
      errors.push_back(report.error());
    } else {
      std::ranges::move(unreadable_folders(*report), std::back_inserter(errors));
    }
  }
  return errors;
}

}  // namespace syncline::eni
