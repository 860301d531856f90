#include "ui/panels/pasted_points.h"

#include "core/document/limits.h"
#include "ui/shell/language/number_text.h"

#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace kriva::ui {
namespace {

std::optional<double> coordinate(const QString& text) {
    const std::optional<double> number = parseNumber(text);
    return number && std::abs(*number) <= limits::kNumber ? number : std::nullopt;
}

std::optional<Point> pointOf(const QStringList& cells) {
    if (cells.size() != 2)
        return {};
    const std::optional<double> x = coordinate(cells[0]);
    const std::optional<double> y = coordinate(cells[1]);
    return x && y ? std::optional(Point{*x, *y}) : std::nullopt;
}

std::optional<Points> pointsOf(const QStringList& lines, const QRegularExpression& separator) {
    Points points;
    for (const QString& line : lines) {
        const std::optional<Point> point = pointOf(line.split(separator));
        if (!point)
            return {};
        points.push_back(*point);
    }
    return points;
}

} // namespace

std::optional<Points> pastedPoints(const QString& text) {
    static const QRegularExpression wideSeparator(QStringLiteral("\\s*[\\t;]\\s*|\\s+"));
    static const QRegularExpression comma(QStringLiteral(","));
    QStringList lines;
    for (const QString& line : text.split(QLatin1Char('\n')))
        if (const QString trimmed = line.trimmed(); !trimmed.isEmpty())
            lines.append(trimmed);
    if (lines.isEmpty() || lines.size() > static_cast<qsizetype>(limits::kPointsInCurve))
        return {};
    // One way of reading for the whole table: a comma is the decimal sign in all lines or the separator in all.
    std::optional<Points> points = pointsOf(lines, wideSeparator);
    return points ? points : pointsOf(lines, comma);
}

} // namespace kriva::ui
