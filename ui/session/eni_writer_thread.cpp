// SPDX-License-Identifier: Apache-2.0
#include "ui/session/eni_writer_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "eni/format/eni_file.h"
#include "settings/other_value.h"
#include "settings/settings_table.h"
#include "ui/session/project_copy.h"

namespace syncline::ui {
namespace {

/// The last text, the one before it, and what it is compared with.
constexpr std::size_t kKnownTexts = 4;
/// Other values of a setting; of a choice among a thousand slaves one is as good as another.
constexpr int kMostTried = 8;
/// A long check is not begun while somebody edits on.
constexpr std::size_t kLongText = 1'000'000;
constexpr std::chrono::milliseconds kPause{400};

}  // namespace

EniWriterThread::EniWriterThread(Answers answers) : answers_(std::move(answers)), thread_([this] { run(); }) {}

EniWriterThread::~EniWriterThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void EniWriterThread::ask(Request request) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(request);
  }
  wake_.notify_one();
}

/// There is another request, or comes within a moment.
bool EniWriterThread::superseded(bool patient) {
  std::unique_lock lock(mutex_);
  return wake_.wait_for(lock, patient ? kPause : std::chrono::milliseconds(0), [this] { return ending_ || next_; });
}

void EniWriterThread::run() {
  while (true) {
    Request request;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return ending_ || next_; });
      if (ending_) return;
      request = std::move(*std::exchange(next_, std::nullopt));
    }
    const auto view = write(request);
    answers_.written(request.number, view);
    if (!view || superseded((*view)->text->text.size() > kLongText)) continue;
    const auto check = eni::check_eni_text((*view)->text->text, "ENI");
    answers_.checked(request.number, check ? std::make_shared<const eni::EniCheck>(*check) : nullptr);
  }
}

Result<std::shared_ptr<const EniView>> EniWriterThread::write(const Request& request) {
  auto& compiler = compilers_[static_cast<std::size_t>(request.dialect)];
  const auto compiled = compiler.update(request.now->project());
  if (!compiled) return tl::unexpected(compiled.error());
  const bool changes = request.key.empty() && request.before != nullptr;
  const auto before = changes ? linesOf(request.before, request.dialect) : nullptr;
  const auto text = EniLines::of(eni::write_eni((*compiled)->config, eni::style_of(request.dialect)));
  remember(request.now, request.dialect, text);
  auto view = request.key.empty() ? EniView::of(text, before) : dependents(request, text);
  view->dialect = request.dialect;
  view->findings = (*compiled)->findings;
  return std::shared_ptr<const EniView>(std::move(view));
}

/// Tries other values of the setting until one makes another text of it.
std::shared_ptr<EniView> EniWriterThread::dependents(const Request& request,
                                                     const std::shared_ptr<const EniLines>& text) {
  EniTrial trial;
  trial.key = request.key;
  auto other = text;
  const auto project = request.now->project();
  if (const auto ref = settings::find(project, request.key, false)) {
    int left = kMostTried;
    for (const auto& value : settings::other_values(*ref->setting, project, ref->place)) {
      if (left-- == 0 || other != text || superseded(false)) break;
      auto tried = project;
      if (!settings::set_value(*ref->setting, tried, ref->place, value)) continue;
      const auto compiled = compile(tried, {request.dialect});
      if (!compiled) continue;
      trial.tried = true;
      trial.value = settings::text_with_unit(*ref->setting, tried, ref->place);
      auto made = eni::write_eni(compiled->config, eni::style_of(request.dialect));
      if (made != text->text) other = EniLines::of(std::move(made));
    }
  }
  auto view = EniView::of(text, other);
  view->trial = std::move(trial);
  return view;
}

/// Of a project that cannot be compiled there is no text: all is new.
std::shared_ptr<const EniLines> EniWriterThread::linesOf(const std::shared_ptr<const ProjectCopy>& project,
                                                         EniDialect dialect) {
  const auto found = std::ranges::find_if(
      known_, [&](const Known& known) { return known.project == project && known.dialect == dialect; });
  if (found != known_.end()) {
    std::rotate(found, found + 1, known_.end());
    return known_.back().lines;
  }
  const auto compiled = compile(project->project(), {dialect});
  auto lines = EniLines::of(compiled ? eni::write_eni(compiled->config, eni::style_of(dialect)) : std::string());
  remember(project, dialect, lines);
  return lines;
}

void EniWriterThread::remember(const std::shared_ptr<const ProjectCopy>& project, EniDialect dialect,
                               const std::shared_ptr<const EniLines>& lines) {
  if (known_.size() >= kKnownTexts) known_.erase(known_.begin());
  known_.push_back({project, dialect, lines});
}

}  // namespace syncline::ui
