// SPDX-License-Identifier: Apache-2.0
#include "ui/session/diag_text_reader.h"

#include <QFuture>
#include <QLocale>
#include <QPromise>
#include <QThreadPool>
#include <algorithm>
#include <utility>

#include "config/esi_text.h"
#include "ui/session/device_catalogue.h"

namespace syncline::ui {
namespace {

constexpr int kEnglish = 1033, kGerman = 1031, kChinese = 2052;  // LcId

int languageOfTexts() {
  switch (QLocale().language()) {
    case QLocale::German:
      return kGerman;
    case QLocale::Chinese:
      return kChinese;
    default:
      return kEnglish;
  }
}

Identity withoutSerial(Identity identity) {
  identity.serial_no = 0;
  return identity;
}

}  // namespace

DiagTextReader::DiagTextReader(DeviceCatalogue& catalogue, QObject* parent) : QObject(parent), catalogue_(catalogue) {}

void DiagTextReader::want(const Identity& wanted) {
  const auto identity = withoutSerial(wanted);
  const auto key = to_string(identity);
  if (const auto known = known_.find(key); known != known_.end()) {
    Q_EMIT told(identity, known->second);
    return;
  }
  if (std::exchange(asked_, key) == key) return;
  catalogue_.revisions(identity, this, [this, identity](const Result<std::vector<eni::CatalogueEntry>>& entries) {
    if (!entries || entries->empty()) return keep(identity, {});
    // Newest first: a revision that no file has is best told by the next.
    const auto exact = std::ranges::find_if(
        *entries, [&](const auto& entry) { return entry.identity.revision_no == identity.revision_no; });
    const auto& entry = exact == entries->end() ? entries->front() : *exact;
    readFile(identity, entry.file, withoutSerial(entry.identity));
  });
}

void DiagTextReader::readFile(const Identity& identity, const std::string& file, const Identity& in_file) {
  const auto promise = std::make_shared<QPromise<DiagTexts>>();
  auto future = promise->future();
  future.then(this, [this, identity](const DiagTexts& texts) { keep(identity, texts); });
  QThreadPool::globalInstance()->start([promise, file, in_file, language = languageOfTexts()] {
    promise->start();
    promise->addResult(eni::read_diag_messages(file, in_file, {.language = language}).value_or(DiagTexts{}));
    promise->finish();
  });
}

void DiagTextReader::keep(const Identity& identity, DiagTexts texts) {
  const auto key = to_string(identity);
  if (asked_ == key) asked_.clear();
  const auto& kept = known_[key] = std::move(texts);
  Q_EMIT told(identity, kept);
}

}  // namespace syncline::ui
