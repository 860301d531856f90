#include "ui/figures/figure_ink.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

#include <algorithm>

namespace kriva::ui {
namespace {

[[nodiscard]] double widthOf(const QString& text, const QFont& font) {
    return QFontMetricsF(font).horizontalAdvance(text);
}

/// One family, for Qt ranks all fonts of the system as substitutes when it is given a list or a family that is not
/// there. The last one is any serif.
[[nodiscard]] QString firstInstalled(const QStringList& families) {
    const QStringList installed = QFontDatabase::families();
    const auto isInstalled = [&](const QString& family) {
        const QString withFoundry = family + QStringLiteral(" ["); // how Qt tells namesakes apart
        return std::ranges::any_of(installed,
                                   [&](const QString& name) { return name == family || name.startsWith(withFoundry); });
    };
    const auto found = std::ranges::find_if(families, isInstalled);
    return found == families.end() ? families.last() : *found;
}

} // namespace

QPen penOf(const RoleStyle& style, double pointSize) {
    QPen pen(toQt(style.color), style.width * pointSize, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin);
    if (!style.dashes.empty() && style.width > 0) {
        QList<double> inWidths;
        for (const double length : style.dashes)
            inWidths.append(length / style.width);
        pen.setDashPattern(inWidths);
    }
    return pen;
}

void paintMark(QPainter& painter, const RoleStyle& style, QPointF at, double pointSize) {
    const double size = style.markerSize * pointSize;
    const QRectF square(at.x() - size / 2, at.y() - size / 2, size, size);
    painter.setPen(style.markerWidth > 0 ? QPen(toQt(style.color), style.markerWidth * pointSize) : QPen(Qt::NoPen));
    painter.setBrush(style.marker == Marker::ring ? QBrush(Qt::NoBrush) : QBrush(toQt(style.markerFill)));
    switch (style.marker) {
    case Marker::none:
        break;
    case Marker::circle:
    case Marker::ring:
        painter.drawEllipse(square);
        break;
    case Marker::square:
        painter.drawRect(square);
        break;
    case Marker::diamond:
        painter.drawPolygon(QPolygonF({{at.x() - size / 2, at.y()},
                                       {at.x(), at.y() - size / 2},
                                       {at.x() + size / 2, at.y()},
                                       {at.x(), at.y() + size / 2}}));
        break;
    }
}

LabelFonts labelFonts(double pointSize) {
    static const QString family = firstInstalled(QString::fromUtf8(kTextFamily).split(QStringLiteral(", ")));
    QFont text(family);
    text.setPixelSize(std::max(1, qRound(kTextSize * pointSize)));
    LabelFonts fonts{text, text, text};
    fonts.variable.setItalic(true);
    fonts.subscript.setPixelSize(std::max(1, qRound(kSubscriptSize * pointSize)));
    return fonts;
}

void paintLabel(QPainter& painter, const PlacedLabel& label, QPointF baseline, const LabelFonts& fonts) {
    const QString text = QString::fromStdString(label.text);
    const QString subscript = QString::fromStdString(label.subscript);
    const QString suffix = QString::fromStdString(label.suffix);
    const QFont& textFont = label.isVariable ? fonts.variable : fonts.text;
    const double textWidth = widthOf(text, textFont);
    const double subscriptWidth = widthOf(subscript, fonts.subscript);
    const double width = textWidth + subscriptWidth + widthOf(suffix, fonts.text);
    const double drop = kSubscriptDrop / kTextSize * fonts.text.pixelSize();
    double x = baseline.x();
    if (label.anchor != TextAnchor::start)
        x -= label.anchor == TextAnchor::middle ? width / 2 : width;
    const auto write = [&](const QFont& font, const QString& words, double y) {
        painter.setFont(font);
        painter.drawText(QPointF(x, y), words);
        x += widthOf(words, font);
    };
    write(textFont, text, baseline.y());
    write(fonts.subscript, subscript, baseline.y() + drop);
    write(fonts.text, suffix, baseline.y());
}

} // namespace kriva::ui
