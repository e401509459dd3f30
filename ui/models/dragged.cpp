// SPDX-License-Identifier: Apache-2.0
#include "ui/models/dragged.h"

#include <QMimeData>
#include <QUuid>
#include <memory>

namespace syncline::ui {
namespace {

/// Known to this window alone; two of them have the same slaves and other devices.
const QByteArray& windowToken() {
  static const QByteArray token = QUuid::createUuid().toByteArray(QUuid::WithoutBraces);
  return token;
}

QMimeData* dragged(const QString& mime, const QByteArray& what) {
  auto data = std::make_unique<QMimeData>();
  data->setData(mime, windowToken() + ' ' + what);
  return data.release();
}

/// The words behind the token; empty: it is not ours.
QList<QByteArray> wordsOf(const QMimeData& data, const QString& mime) {
  auto words = data.data(mime).split(' ');
  return words.size() > 1 && words.takeFirst() == windowToken() ? words : QList<QByteArray>();
}

}  // namespace

QMimeData* draggedSlave(int address) { return dragged(kSlaveMime, QByteArray::number(address)); }

std::optional<int> addressOf(const QMimeData& data) {
  const auto words = wordsOf(data, kSlaveMime);
  bool good = false;
  const int address = words.isEmpty() ? 0 : words.front().toInt(&good);
  return good ? std::optional(address) : std::nullopt;
}

QMimeData* draggedMembers(const std::vector<DraggedMember>& members) {
  QByteArrayList words;
  for (const auto& [address, outputs, inputs] : members)
    words << QByteArray::number(address) + (outputs ? "o" : "") + (inputs ? "i" : "");
  return dragged(kUnitMembersMime, words.join(' '));
}

std::vector<DraggedMember> membersOf(const QMimeData& data) {
  std::vector<DraggedMember> members;
  for (auto word : wordsOf(data, kUnitMembersMime)) {
    DraggedMember member;
    member.outputs = word.contains('o');
    member.inputs = word.contains('i');
    while (word.endsWith('o') || word.endsWith('i')) word.chop(1);
    member.address = word.toInt();
    members.push_back(member);
  }
  return members;
}

QMimeData* draggedDevice(const DraggedDevice& device) {
  return dragged(kDeviceMime, QByteArray::number(device.id) + ' ' + QByteArray::fromStdString(device.physics));
}

std::optional<DraggedDevice> deviceOf(const QMimeData& data) {
  const auto words = wordsOf(data, kDeviceMime);
  bool good = false;
  const qint64 id = words.size() < 2 ? 0 : words[0].toLongLong(&good);
  return good ? std::optional(DraggedDevice{id, words[1].toStdString()}) : std::nullopt;
}

}  // namespace syncline::ui
