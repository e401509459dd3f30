// SPDX-License-Identifier: Apache-2.0
#include "engine/try_esi.h"

#include <malloc.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <thread>

#include "engine/trial_files.h"
#include "findings/error_text.h"
#include "support/distinct_files.h"
#include "support/input_file.h"
#include "support/paths_in.h"

namespace syncline {
namespace {

constexpr unsigned kMostThreads = 8;

bool is_xml(const std::filesystem::path& path) {
  auto extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return extension == ".xml";
}

Error unreadable(const std::string& path, const std::error_code& error) {
  const bool missing = error == std::errc::no_such_file_or_directory;
  return {.code = missing ? ErrorCode::kFileNotFound : ErrorCode::kFileNotReadable,
          .detail = Reason::phrase(error.message()),
          .file = path};
}

/// The ESI files of a folder and of those below it, and what of them cannot be looked into.
struct FoundFiles {
  std::vector<std::string> files;
  std::vector<Error> unreadable;

  [[nodiscard]] std::error_code add(const std::filesystem::path& folder) {
    std::error_code error;
    for (const auto& path : paths_in(folder, error)) {
      std::error_code none;
      if (std::filesystem::is_directory(path, none)) {
        // A link to a folder may lead back up.
        if (std::filesystem::is_symlink(path, none)) continue;
        if (const auto below = add(path)) unreadable.push_back(syncline::unreadable(path.string(), below));
      } else if (is_xml(path) && !is_stream(path.string())) {
        files.push_back(path.string());
      }
    }
    return error;
  }
};

Result<FoundFiles> files_of(const std::string& path) {
  FoundFiles found;
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) {
    found.files.push_back(path);
    return found;
  }
  if (const auto failed = found.add(path)) return fail(unreadable(path, failed));
  std::ranges::sort(found.files);  // the same folder gives the same report on every machine
  return found;
}

TriedDevice rejected(const Error& error) {
  return {.file = error.file,
          .line = error.line,
          .outcome = TryOutcome::kExcepted,
          .step = TryStep::kRead,
          .reason = "the ESI file does not describe it: " + describe(error)};
}

/// "Maker_Drives-": what the ENI of each of its devices begins with; "below-Maker_Drives-" for a file in a folder
/// below.
std::string kept_stem(const std::string& file, const std::string& folder) {
  const auto path = std::filesystem::path(file);
  auto stem = path == std::filesystem::path(folder)
                  ? path.stem().string()
                  : path.lexically_relative(folder).replace_extension().generic_string();
  std::ranges::replace(stem, '/', '-');
  return stem + '-';
}

/// No ESI file has a name that the ENI of another's device will get. Which numbers there are is known only when all are
/// read, and by then the first are written: any number counts.
Status check_kept(const TryRequest& request, const std::vector<std::string>& files) {
  std::error_code error;
  for (const auto& path : paths_in(request.keep, error)) {
    const auto name = path.filename().string();
    const auto may_become = [&](const std::string& file) {
      const auto stem = kept_stem(file, request.path);
      const auto number = name.size() > stem.size() ? name.substr(stem.size(), name.rfind('.') - stem.size()) : "";
      return name.starts_with(stem) && name.ends_with(".xml") && !number.empty() &&
             number.find_first_not_of("0123456789") == std::string::npos;
    };
    if (std::ranges::none_of(files, may_become)) continue;
    const NamedFile written[]{{"--keep", path.string()}};
    std::vector<NamedFile> read;
    for (const auto& file : files) read.push_back({"the argument path", file});
    if (auto status = check_distinct(read, written); !status) return status;
  }
  return {};
}

/// Files are taken by the threads one by one; each has its place in the report.
class Trial {
 public:
  Trial(const TryRequest& request, const TrialFiles& formats, FoundFiles found)
      : request_(request), formats_(formats), files_(std::move(found.files)), of_file_(files_.size()) {
    report_.unreadable = std::move(found.unreadable);
  }

  TryReport run() {
    const unsigned processors = std::max(std::thread::hardware_concurrency(), 1U);
    const unsigned wanted = std::min(request_.threads != 0 ? request_.threads : processors, kMostThreads);
    {
      std::vector<std::jthread> threads;
      threads.reserve(wanted);
      try {
        for (unsigned i = 1; i < wanted; ++i) threads.emplace_back([this] { work_guarded(); });
      } catch (const std::system_error&) {
        // With fewer threads it takes longer.
      }
      work_guarded();
    }
    if (failure_) std::rethrow_exception(failure_);
    report_.cancelled = stopped();
    for (auto& tried : of_file_) std::ranges::move(tried, std::back_inserter(report_.devices));
    report_.files = files_.size();
    std::ranges::sort(report_.unreadable, {}, &Error::file);
    return std::move(report_);
  }

 private:
  [[nodiscard]] bool stopped() const { return failed_ || (request_.stop != nullptr && request_.stop->load()); }

  /// Memory that there is not ends the trial, not the program.
  void work_guarded() noexcept {
    try {
      work();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      failed_ = true;
    }
  }

  void work() {
    for (std::size_t i = next_++; i < files_.size() && !stopped(); i = next_++) try_file(i);
  }

  /// Reading takes a few times a file's size: large ones are read one after the other, and what that had goes back to
  /// the system before the devices are tried.
  [[nodiscard]] Result<TrialDevices> read(const std::string& path) {
    constexpr std::uintmax_t kLarge = 1U << 20;
    std::error_code none;
    const auto size = std::filesystem::file_size(path, none);
    if (none || size < kLarge) return formats_.read_devices(path);
    const std::lock_guard lock(reading_);
    auto file = formats_.read_devices(path);
    ::malloc_trim(0);
    return file;
  }

  void try_file(std::size_t number) {
    const auto file = read(files_[number]);
    if (!file) {
      const std::lock_guard lock(mutex_);
      report_.unreadable.push_back(file.error());
      return;
    }
    for (const Error& error : file->rejected) done(number, rejected(error));
    for (std::size_t i = 0; i < file->devices.size() && !stopped(); i += std::max(request_.every, 1U)) {
      done(number, try_device(file->devices[i], formats_, kept_file(files_[number], i)));
    }
  }

  /// "KEEP/Maker_Drives-3.xml": the third device of Maker_Drives.xml.
  [[nodiscard]] std::string kept_file(const std::string& file, std::size_t device) const {
    if (request_.keep.empty()) return {};
    const auto name = kept_stem(file, request_.path) + std::to_string(device + 1) + ".xml";
    return (std::filesystem::path(request_.keep) / name).string();
  }

  void done(std::size_t number, TriedDevice tried) {
    const std::lock_guard lock(mutex_);
    if (request_.on_device) request_.on_device(tried);
    of_file_[number].push_back(std::move(tried));
  }

  const TryRequest& request_;
  const TrialFiles& formats_;
  std::vector<std::string> files_;
  std::vector<std::vector<TriedDevice>> of_file_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;
  std::mutex mutex_, reading_;
  TryReport report_;
};

}  // namespace

std::size_t TryReport::count(TryOutcome outcome) const {
  return static_cast<std::size_t>(std::ranges::count(devices, outcome, &TriedDevice::outcome));
}

Result<TryReport> try_esi(const TryRequest& request, const TrialFiles& files) {
  auto found = files_of(request.path);
  if (!found) return tl::unexpected(found.error());
  if (auto status = check_kept(request, found->files); !status) return tl::unexpected(status.error());
  return Trial(request, files, std::move(*found)).run();
}

}  // namespace syncline
