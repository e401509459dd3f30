// SPDX-License-Identifier: Apache-2.0
#include "ui/theme/theme.h"

#include <QApplication>

#include "ui/theme/line_icon.h"
#include "ui/theme/window_style.h"

/// A static library's resources are linked in by this call; the macro must stand outside of any namespace.
static void linkResources() { Q_INIT_RESOURCE(syncline); }

namespace syncline::ui::theme {
namespace {

Mode g_mode = Mode::kSystem;

struct Colors {
  QRgb window, base, alternate, button, text, muted, disabled, outline, mid, accent, on_accent, tip, tip_text, link;
};

struct ToneColors {
  QRgb good, busy, warning, bad;
  int fill;  // alpha of a quiet fill
};

constexpr ToneColors kLightTones{0xFF0B6E42, 0xFF14648C, 0xFF8F5600, 0xFFB3261E, 26};
constexpr ToneColors kDarkTones{0xFF5FCF93, 0xFF6CB8E6, 0xFFE9B34E, 0xFFF4867C, 40};
constexpr ToneColors kContrastTones{0xFF7CFFB2, 0xFF8FD8FF, 0xFFFFD75E, 0xFFFFA59C, 40};

constexpr Colors kLight{0xFFF3F5F7, 0xFFFFFFFF, 0xFFF7F9FA, 0xFFFBFCFD, 0xFF1B2430, 0xFF5A6675, 0xFF98A2AE,
                        0xFFD3D9E0, 0xFFBCC4CD, 0xFF14648C, 0xFFFFFFFF, 0xFF1F2A37, 0xFFF2F5F8, 0xFF14648C};
constexpr Colors kDark{0xFF1E242B, 0xFF171C22, 0xFF1B2128, 0xFF2A323B, 0xFFE4E9EE, 0xFF9BA7B4, 0xFF66717D,
                       0xFF38424D, 0xFF4A5662, 0xFF2F7FA8, 0xFFFFFFFF, 0xFFE4E9EE, 0xFF1B2430, 0xFF7CC0E6};
constexpr Colors kContrast{0xFF000000, 0xFF000000, 0xFF141414, 0xFF000000, 0xFFFFFFFF, 0xFFDCDCDC, 0xFFA6A6A6,
                           0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFE100, 0xFF000000, 0xFF000000, 0xFFFFFFFF, 0xFF8FD8FF};

QPalette paletteOf(const Colors& c) {
  QPalette palette;
  const auto set = [&palette](QPalette::ColorRole role, QRgb color) { palette.setColor(role, QColor::fromRgb(color)); };
  set(QPalette::Window, c.window);
  set(QPalette::WindowText, c.text);
  set(QPalette::Base, c.base);
  set(QPalette::AlternateBase, c.alternate);
  set(QPalette::Text, c.text);
  set(QPalette::Button, c.button);
  set(QPalette::ButtonText, c.text);
  set(QPalette::BrightText, c.on_accent);
  set(QPalette::Highlight, c.accent);
  set(QPalette::HighlightedText, c.on_accent);
  set(QPalette::Link, c.link);
  set(QPalette::LinkVisited, c.link);
  set(QPalette::PlaceholderText, c.muted);
  set(QPalette::ToolTipBase, c.tip);
  set(QPalette::ToolTipText, c.tip_text);
  set(QPalette::Light, c.base);
  set(QPalette::Midlight, c.alternate);
  set(QPalette::Mid, c.mid);
  set(QPalette::Dark, c.mid);
  palette.setColor(QPalette::Shadow, QColor(0, 0, 0, 60));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, QColor::fromRgb(c.disabled));
  }
  // Of the ground that they stand on: a field that takes nothing now is no hole to write into.
  palette.setColor(QPalette::Disabled, QPalette::Base, QColor::fromRgb(c.window));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor::fromRgb(c.outline));
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, QColor::fromRgb(c.muted));
  return palette;
}

/// Fusion draws the frames of controls in a darkened window colour, which vanishes on a dark ground. These
/// classes paint no window of their own, so they can be given the colour whose darkening is our line.
void setControlOutlines(const QPalette& palette, const Colors& colors) {
  auto controls = palette;
  controls.setColor(QPalette::Window, QColor::fromRgb(colors.mid).lighter(140));
  for (const char* name : {"QCheckBox", "QRadioButton", "QAbstractSpinBox", "QLineEdit", "QComboBox", "QPushButton",
                           "QAbstractItemView"}) {
    QApplication::setPalette(controls, name);
  }
}

/// Nothing but black is the ground of no other theme. Of a desktop's palette, too.
bool isContrast(const QPalette& palette) { return isDark(palette) && palette.color(QPalette::Base) == Qt::black; }

const Colors& colorsOf(const QPalette& palette) {
  return isContrast(palette) ? kContrast : isDark(palette) ? kDark : kLight;
}

const ToneColors& tonesOf(const QPalette& palette) {
  return isContrast(palette) ? kContrastTones : isDark(palette) ? kDarkTones : kLightTones;
}

}  // namespace

QString modeName(Mode mode) {
  switch (mode) {
    case Mode::kLight:
      return QStringLiteral("light");
    case Mode::kDark:
      return QStringLiteral("dark");
    case Mode::kContrast:
      return QStringLiteral("contrast");
    case Mode::kSystem:
      break;
  }
  return QStringLiteral("system");
}

Mode modeFromName(const QString& name) {
  if (name == QLatin1String("light")) return Mode::kLight;
  if (name == QLatin1String("dark")) return Mode::kDark;
  if (name == QLatin1String("contrast")) return Mode::kContrast;
  return Mode::kSystem;
}

void apply(Mode mode) {
  // The desktop's palette must be asked before ours is set for the first time.
  static const QPalette desktop = QApplication::palette();
  linkResources();
  g_mode = mode;
  if (dynamic_cast<const WindowStyle*>(QApplication::style()) == nullptr) QApplication::setStyle(new WindowStyle);
  const auto& colors = mode == Mode::kSystem     ? colorsOf(desktop)
                       : mode == Mode::kContrast ? kContrast
                       : mode == Mode::kDark     ? kDark
                                                 : kLight;
  const auto palette = paletteOf(colors);
  QApplication::setPalette(palette);
  setControlOutlines(palette, colors);
}

Mode current() { return g_mode; }

QPalette lightPalette() { return paletteOf(kLight); }

/// By the ground of lists and fields: controls have another window colour, for their outlines.
bool isDark(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < palette.color(QPalette::Text).lightness();
}

QColor toneColor(const QPalette& palette, Tone tone) {
  const auto& tones = tonesOf(palette);
  switch (tone) {
    case Tone::kGood:
      return QColor::fromRgb(tones.good);
    case Tone::kBusy:
    case Tone::kAccent:
      return QColor::fromRgb(tones.busy);
    case Tone::kWarning:
      return QColor::fromRgb(tones.warning);
    case Tone::kBad:
      return QColor::fromRgb(tones.bad);
    case Tone::kNeutral:
      break;
  }
  return mutedText(palette);
}

QColor toneFill(const QPalette& palette, Tone tone) {
  auto color = toneColor(palette, tone);
  color.setAlpha(tonesOf(palette).fill);
  return color;
}

Tone stateTone(AlState state) {
  switch (state) {
    case AlState::kOp:
      return Tone::kGood;
    case AlState::kSafeop:
      return Tone::kWarning;
    case AlState::kPreop:
    case AlState::kBoot:
      return Tone::kBusy;
    case AlState::kInit:
      return Tone::kNeutral;
    case AlState::kNone:
      break;
  }
  return Tone::kBad;
}

QColor mutedText(const QPalette& palette) { return QColor::fromRgb(colorsOf(palette).muted); }

QColor outline(const QPalette& palette) { return QColor::fromRgb(colorsOf(palette).outline); }

QIcon icon(const QString& name, const QPalette& palette, const QColor& color) {
  if (!LineIcon::exists(name)) return {};
  return QIcon(
      new LineIcon(name, {.normal = color.isValid() ? color : palette.color(QPalette::Active, QPalette::ButtonText),
                          .disabled = palette.color(QPalette::Disabled, QPalette::ButtonText),
                          .selected = palette.color(QPalette::HighlightedText)}));
}

}  // namespace syncline::ui::theme
