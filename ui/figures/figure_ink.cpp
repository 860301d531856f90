#include "ui/figures/figure_ink.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

#include <algorithm>
#include <array>

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

namespace {

/// Words of one font, and where they start.
struct LabelPart {
    const QFont& font;
    QString words;
    QPointF at;
};

std::array<LabelPart, 3> partsOf(const PlacedLabel& label, QPointF baseline, const LabelFonts& fonts) {
    const double drop = kSubscriptDrop / kTextSize * fonts.text.pixelSize();
    std::array<LabelPart, 3> parts{{
        {label.isVariable ? fonts.variable : fonts.text, QString::fromStdString(label.text), baseline},
        {fonts.subscript, QString::fromStdString(label.subscript), baseline + QPointF(0, drop)},
        {fonts.text, QString::fromStdString(label.suffix), baseline},
    }};
    double width = 0;
    for (LabelPart& part : parts) {
        part.at.rx() += width;
        width += widthOf(part.words, part.font);
    }
    const double back = label.anchor == TextAnchor::start ? 0 : label.anchor == TextAnchor::middle ? width / 2 : width;
    for (LabelPart& part : parts)
        part.at.rx() -= back;
    return parts;
}

} // namespace

QPainterPath labelOutlines(const PlacedLabel& label, QPointF baseline, const LabelFonts& fonts) {
    QPainterPath outlines;
    outlines.setFillRule(Qt::WindingFill);
    for (const LabelPart& part : partsOf(label, baseline, fonts))
        outlines.addText(part.at, part.font, part.words);
    return outlines;
}

void paintLabel(QPainter& painter, const PlacedLabel& label, QPointF baseline, const LabelFonts& fonts) {
    for (const LabelPart& part : partsOf(label, baseline, fonts)) {
        painter.setFont(part.font);
        painter.drawText(part.at, part.words);
    }
}

} // namespace kriva::ui
