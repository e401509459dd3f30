// SPDX-License-Identifier: Apache-2.0
#include "app/cli/run_black_box.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "app/cli/options.h"
#include "app/cli/terminal_reason.h"
#include "channels/master_channels.h"
#include "findings/error_text.h"
#include "support/counted.h"

namespace syncline::cli {
namespace {

constexpr std::uint64_t kBytesPerMiB = 1ULL << 20;

}  // namespace

void add_black_box_options(CLI::App& command, BlackBoxOptions& options) {
  auto* box = command.add_option(
      "--black-box", options.name,
      "Keep the last frames in files NAME_NUMBER_TIME.pcapng, whole also after a crash; a folder is a "
      "name, too");
  command.add_option("--black-box-mib", options.mib, "Size of these files together; the oldest goes first")
      ->needs(box)
      ->capture_default_str();
  command
      .add_option("--black-box-keep-free-mib", options.keep_free_mib,
                  "End the black box when the disk has less room than this left; the run goes on")
      ->needs(box)
      ->capture_default_str();
}

Status RunBlackBox::start(MasterChannels& channels, const std::string& file, const std::string& link,
                          bool virtual_time) {
  if (options_.name.empty()) return {};
  if (options_.mib == 0) return fail(ErrorCode::kBadValue, "--black-box-mib", in_terminal("use 1 or more"));
  auto box = BlackBox::start(channels.frames,
                             {.name = options_.name,
                              .most_bytes = options_.mib * kBytesPerMiB,
                              .keep_free_bytes = options_.keep_free_mib * kBytesPerMiB,
                              .virtual_time = virtual_time,
                              .program = std::string("synclinectl ") + SYNCLINE_VERSION,
                              .link = link,
                              .description = std::filesystem::path(file).filename().string()},
                             [this](const Error& error) {
                               const std::lock_guard lock(mutex_);
                               stopped_ = error;
                             });
  if (!box) return tl::unexpected(box.error());
  box_ = std::move(*box);
  return {};
}

void RunBlackBox::add(const Event& event) {
  if (box_) box_->note(event);
}

void RunBlackBox::tell() {
  const std::lock_guard lock(mutex_);
  if (stopped_) context_.fail_with(*std::exchange(stopped_, std::nullopt));
}

void RunBlackBox::finish() {
  if (!box_) return;
  (void)box_->finish();
  tell();
}

Json RunBlackBox::json() const {
  const auto report = box_->report();
  const bool some = report.frames > 0;
  return {{"name", report.name},
          {"file", report.file.empty() ? Json(nullptr) : Json(report.file)},
          {"files", report.files},
          {"bytes", report.bytes},
          {"frames", report.frames},
          {"replaced", report.replaced},
          {"lost", report.lost},
          {"begin_ns", some ? Json(report.begin) : Json(nullptr)},
          {"end_ns", some ? Json(report.end) : Json(nullptr)},
          {"error", report.error ? Json(describe(*report.error)) : Json(nullptr)}};
}

std::string RunBlackBox::text() const {
  const auto report = box_->report();
  auto text = fmt::format("black box {}_*.pcapng: {}, {:.1f} MiB; ", report.name, counted(report.files, "file"),
                          static_cast<double>(report.bytes) / static_cast<double>(kBytesPerMiB));
  if (report.frames == 0) {
    text += "no frame of this run";
  } else {
    text += fmt::format("{} of the last {:.3f} s of it", counted(report.frames, "frame"),
                        static_cast<double>(report.end - report.begin) / 1e9);
    if (report.replaced > 0) text += fmt::format(", {} before them replaced", report.replaced);
  }
  return text + fmt::format(", {} lost\n", report.lost);
}

}  // namespace syncline::cli
