// SPDX-License-Identifier: Apache-2.0
#include "eni/catalogue/usual_sources.h"

#include <filesystem>
#include <iterator>
#include <utility>

namespace syncline::eni {

std::vector<std::string> usual_sources(const EsiCatalogue& catalogue, std::vector<std::string> own) {
  auto sources = catalogue.known_folders().value_or(std::vector<std::string>{});
  std::erase_if(sources, [](const std::string& source) {
    std::error_code error;
    return !std::filesystem::exists(source, error);
  });
  std::move(own.begin(), own.end(), std::back_inserter(sources));
  return sources;
}

Status add_source(EsiCatalogue& catalogue, const std::string& path, const IndexCallback& callback) {
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) return catalogue.add_file(path);
  const auto report = catalogue.add_folder(path, callback);
  if (!report) return tl::unexpected(report.error());
  return report->cancelled ? Status(fail(ErrorCode::kCancelled)) : Status{};
}

std::vector<Error> add_usual_sources(EsiCatalogue& catalogue, std::vector<std::string> own,
                                     const IndexCallback& callback) {
  std::vector<Error> errors;
  for (const auto& source : usual_sources(catalogue, std::move(own))) {
    const auto status = add_source(catalogue, source, callback);
    if (!status && status.error().code == ErrorCode::kCancelled) break;
    if (!status) errors.push_back(status.error());
  }
  return errors;
}

}  // namespace syncline::eni
