// SPDX-License-Identifier: Apache-2.0
#include "ui/session/eni_preview.h"

#include <chrono>
#include <utility>

#include "ui/session/eni_writer_thread.h"
#include "ui/session/post.h"
#include "ui/session/project_copy.h"
#include "ui/session/project_document.h"

namespace syncline::ui {
namespace {

constexpr std::chrono::milliseconds kEditsWithin{40};
/// While nobody looks at the ENI its findings can wait until the user pauses.
constexpr std::chrono::milliseconds kPauseOfEdits{400};

}  // namespace

EniPreview::EniPreview(ProjectDocument& document, QObject* parent) : QObject(parent), document_(document) {
  debounce_.setSingleShot(true);
  debounce_.setInterval(kEditsWithin);
  connect(&debounce_, &QTimer::timeout, this, &EniPreview::start);
  idle_.setSingleShot(true);
  idle_.setInterval(kPauseOfEdits);
  connect(&idle_, &QTimer::timeout, this, &EniPreview::ask);
  connect(&document_, &ProjectDocument::projectChanged, this, &EniPreview::onEdit);
  connect(&document_, &ProjectDocument::taken, this, [this] { other_ = true; });
  connect(&document_, &ProjectDocument::slavesReplaced, this, [this] { key_.clear(); });
  connect(&document_, &ProjectDocument::modifiedChanged, this, [this](bool modified) {
    if (modified || now_ == nullptr) return;
    saved_ = now_;
    if (since_ == Since::kSaved) request();
  });
}

EniPreview::~EniPreview() = default;

void EniPreview::onEdit() {
  last_ = now_;
  now_ = ProjectCopy::of(document_.project(), now_.get());
  edited_ = true;
  computing_ = true;
  if (!debounce_.isActive()) debounce_.start();
  Q_EMIT progressed();
}

/// Only now the undo stack says what kind of edit it was: what is without steps was loaded.
void EniPreview::start() {
  if (now_ == nullptr) now_ = ProjectCopy::of(document_.project(), nullptr);
  if (std::exchange(edited_, false)) {
    const bool other = std::exchange(other_, false);
    if (other || document_.undoStack().count() == 0) {
      opened_ = watched_ ? now_ : nullptr;
      exported_ = last_ = nullptr;
      saved_ = nullptr;  // of a network that comes in work with edits nobody knows it
    }
    if (document_.undoStack().isClean()) saved_ = now_;
  }
  if (watched_ && opened_ == nullptr) opened_ = now_;
  request();
}

void EniPreview::request() {
  if (watched_) return ask();
  idle_.start();
}

void EniPreview::ask() {
  // What was edited last is asked for when start() has seen it.
  if (now_ == nullptr || edited_) return;
  const auto since = watched_ ? before() : nullptr;
  if (asked_ == now_ && asked_before_ == since && asked_dialect_ == dialect_ && asked_key_ == key_) return;
  if (writer_ == nullptr) {
    writer_ = std::make_unique<EniWriterThread>(EniWriterThread::Answers{
        [this](std::uint64_t number, const auto& view) { post(*this, [this, number, view] { take(number, view); }); },
        [this](std::uint64_t number, const auto& check) {
          post(*this, [this, number, check] { takeCheck(number, check); });
        }});
  }
  computing_ = true;
  asked_ = now_;
  asked_before_ = since;
  asked_dialect_ = dialect_;
  asked_key_ = key_;
  writer_->ask({++number_, dialect_, now_, since, key_});
  Q_EMIT progressed();
}

const std::shared_ptr<const ProjectCopy>& EniPreview::before() const {
  static const std::shared_ptr<const ProjectCopy> kNone;
  switch (since_) {
    case Since::kSaved:
      return document_.path().isEmpty() ? kNone : saved_;
    case Since::kExported:
      return exported_;
    case Since::kOpened:
      return opened_;
    case Since::kLastEdit:
      return last_;
  }
  return kNone;
}

void EniPreview::setWatched(bool watched) {
  if (watched == std::exchange(watched_, watched) || !watched) return;
  start();
}

void EniPreview::setDialect(EniDialect dialect) {
  if (dialect == std::exchange(dialect_, dialect)) return;
  request();
}

void EniPreview::setSince(Since since) {
  const bool others = !key_.empty();
  key_.clear();
  if (since == std::exchange(since_, since) && !others) return;
  request();
}

void EniPreview::showDependents(const std::string& key) {
  if (key == key_) return;
  key_ = key;
  request();
}

void EniPreview::setReported(bool reported) {
  if (reported != std::exchange(reported_, reported)) Q_EMIT reportedChanged();
}

void EniPreview::noteExport() {
  if (now_ == nullptr) now_ = ProjectCopy::of(document_.project(), nullptr);
  exported_ = now_;
  if (since_ == Since::kExported) request();
}

/// What comes late is of a project that is no more; the one that follows it is already under way.
void EniPreview::take(std::uint64_t number, const Result<std::shared_ptr<const EniView>>& view) {
  if (number != number_) return;
  computing_ = edited_;
  failure_ = view ? std::nullopt : std::optional(view.error());
  if (view) {
    view_ = *view;
    check_ = nullptr;
    time_ = QDateTime::currentDateTime();
  }
  Q_EMIT changed();
}

void EniPreview::takeCheck(std::uint64_t number, const std::shared_ptr<const eni::EniCheck>& check) {
  if (number != number_) return;
  check_ = check;
  Q_EMIT progressed();
}

}  // namespace syncline::ui
