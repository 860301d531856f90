#include "ui/panels/pasted_points.h"

#include "core/document/limits.h"
#include "ui/shell/number_text.h"

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

} // namespace

std::optional<Points> pastedPoints(const QString& text) {
    static const QRegularExpression wideSeparator(QStringLiteral("\\s*[\\t;]\\s*|\\s+"));
    Points points;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        const QString trimmed = line.trimmed();
        if (trimmed.isEmpty())
            continue;
        std::optional<Point> point = pointOf(trimmed.split(wideSeparator));
        if (!point)
            point = pointOf(trimmed.split(QLatin1Char(',')));
        if (!point || points.size() == limits::kPointsInCurve)
            return {};
        points.push_back(*point);
    }
    return points.empty() ? std::nullopt : std::optional(std::move(points));
}

} // namespace kriva::ui
