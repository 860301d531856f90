#include "ui/base/look/icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>

#include <algorithm>
#include <array>
#include <optional>

namespace kriva::ui {

using namespace Qt::StringLiterals;

namespace {

/// The files of the icons, in the order of IconName.
constexpr std::array kFiles = {"new",
                               "open",
                               "save",
                               "export",
                               "undo",
                               "redo",
                               "add-point",
                               "edit",
                               "zoom-in",
                               "zoom-out",
                               "fit",
                               "grid",
                               "delete",
                               "duplicate",
                               "up",
                               "down",
                               "play",
                               "pause",
                               "slower",
                               "faster",
                               "direction-forward",
                               "direction-backward",
                               "direction-both",
                               "step-forward",
                               "step-back",
                               "loop",
                               "visible",
                               "hidden",
                               "close",
                               "float",
                               "more"};

[[nodiscard]] QPalette::ColorGroup groupOf(QIcon::Mode mode) {
    return mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
}

[[nodiscard]] QPalette::ColorRole roleOf(QIcon::Mode mode) {
    return mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::ButtonText;
}

/// Renders a drawing anew for every size, so that no pixel is ever scaled, and once for each size and colour.
class SvgIcon : public QIconEngine {
  public:
    explicit SvgIcon(const QString& file)
        : file_(u":/icons/%1.svg"_s.arg(file)) {}

    [[nodiscard]] QIconEngine* clone() const override { return new SvgIcon(*this); }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State) override {
        const std::optional<QColor> color = tint(mode);
        const QString key = u"%1 %2x%3 %4"_s.arg(file_, QString::number(size.width()), QString::number(size.height()),
                                                 color ? color->name(QColor::HexArgb) : QString());
        QPixmap pixmap;
        if (!QPixmapCache::find(key, &pixmap)) {
            pixmap = rendered(size, color);
            QPixmapCache::insert(key, pixmap);
        }
        return pixmap;
    }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        painter->drawPixmap(rect, pixmap(rect.size() * painter->device()->devicePixelRatio(), mode, state));
    }

  protected:
    /// The one colour of a drawing that has none of its own.
    [[nodiscard]] virtual std::optional<QColor> tint(QIcon::Mode) const { return std::nullopt; }

  private:
    [[nodiscard]] QPixmap rendered(const QSize& size, const std::optional<QColor>& color) const {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        const int side = std::min(size.width(), size.height());
        const QRect square((size.width() - side) / 2, (size.height() - side) / 2, side, side);
        QSvgRenderer(file_).render(&painter, square);
        if (color) {
            painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
            painter.fillRect(pixmap.rect(), *color);
        }
        return pixmap;
    }

    QString file_;
};

/// The sign of the program. A window system is given all sizes of its windows' icons, drawn before the first of them is
/// seen: these two are what title bars, task bars and switchers show.
class Sign : public SvgIcon {
  public:
    Sign()
        : SvgIcon(u"kriva"_s) {}

    [[nodiscard]] QIconEngine* clone() const override { return new Sign(*this); }
    QList<QSize> availableSizes(QIcon::Mode, QIcon::State) override { return {QSize(32, 32), QSize(64, 64)}; }
};

class TintedIcon : public SvgIcon {
  public:
    TintedIcon(IconName name, std::optional<QPalette> palette)
        : SvgIcon(QString::fromLatin1(kFiles.at(static_cast<std::size_t>(name))))
        , palette_(std::move(palette)) {}

    [[nodiscard]] QIconEngine* clone() const override { return new TintedIcon(*this); }

  protected:
    [[nodiscard]] std::optional<QColor> tint(QIcon::Mode mode) const override {
        return palette_.value_or(QGuiApplication::palette()).color(groupOf(mode), roleOf(mode));
    }

  private:
    std::optional<QPalette> palette_;
};

} // namespace

QIcon icon(IconName name) {
    return QIcon(new TintedIcon(name, std::nullopt));
}

QIcon icon(IconName name, const QPalette& palette) {
    return QIcon(new TintedIcon(name, palette));
}

QIcon applicationIcon() {
    return QIcon(new Sign);
}

} // namespace kriva::ui
