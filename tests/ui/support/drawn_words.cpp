// SPDX-License-Identifier: Apache-2.0
#include "drawn_words.h"

namespace syncline::test {
namespace {

/// Takes all that is painted, and keeps the words.
class WordsEngine final : public QPaintEngine {
 public:
  WordsEngine() : QPaintEngine(AllFeatures) {}
  bool begin(QPaintDevice* /*device*/) override { return true; }
  bool end() override { return true; }
  void updateState(const QPaintEngineState& /*state*/) override {}
  void drawPixmap(const QRectF& /*to*/, const QPixmap& /*pixmap*/, const QRectF& /*from*/) override {}
  void drawImage(const QRectF& /*to*/, const QImage& /*image*/, const QRectF& /*from*/,
                 Qt::ImageConversionFlags /*flags*/) override {}
  void drawPath(const QPainterPath& /*path*/) override {}
  void drawPolygon(const QPointF* /*points*/, int /*count*/, PolygonDrawMode /*mode*/) override {}
  void drawTextItem(const QPointF& /*at*/, const QTextItem& item) override { words << item.text(); }
  [[nodiscard]] Type type() const override { return User; }

  QStringList words;
};

class WordsDevice final : public QPaintDevice {
 public:
  explicit WordsDevice(const QWidget& like) : like_(like) {}
  [[nodiscard]] QPaintEngine* paintEngine() const override { return &engine_; }
  [[nodiscard]] const QStringList& words() const { return engine_.words; }

 protected:
  [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
    switch (metric) {
      case PdmWidth:
        return like_.width();
      case PdmHeight:
        return like_.height();
      case PdmDepth:
        return 32;
      case PdmNumColors:
        return 0;
      case PdmDevicePixelRatio:
        return 1;
      case PdmDevicePixelRatioScaled:
        return static_cast<int>(devicePixelRatioFScale());
      case PdmWidthMM:
        return like_.widthMM();
      case PdmHeightMM:
        return like_.heightMM();
      default:
        return like_.logicalDpiX();
    }
  }

 private:
  const QWidget& like_;
  mutable WordsEngine engine_;
};

}  // namespace

QStringList drawnWords(QWidget& widget) {
  WordsDevice device(widget);
  widget.render(&device, QPoint(), QRegion(), QWidget::RenderFlags());
  return device.words();
}

}  // namespace syncline::test
