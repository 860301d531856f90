#include "ui/exchange/points_table.h"

#include "core/document/limits.h"
#include "ui/shell/language/number_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace kriva::ui {
namespace {

using Reason = TableError::Reason;

constexpr qsizetype kLongestCell = 20; // characters of a refused cell that are told

/// A line that says something, and where it stands.
struct Line {
    QString text;
    int number = 0;
};

std::variant<double, TableError> coordinate(const QString& cell, int line) {
    const std::optional<double> number = parseNumber(cell);
    if (!number)
        return TableError{Reason::noNumber, line, cell};
    if (std::abs(*number) > limits::kNumber)
        return TableError{Reason::outOfRange, line, cell};
    return *number;
}

std::variant<Point, TableError> pointOf(const QStringList& cells, int line) {
    std::array<double, 2> numbers{};
    for (std::size_t i = 0; i < std::min<std::size_t>(2, static_cast<std::size_t>(cells.size())); ++i) {
        const auto read = coordinate(cells[static_cast<qsizetype>(i)], line);
        if (const TableError* error = std::get_if<TableError>(&read))
            return *error;
        numbers[i] = std::get<double>(read);
    }
    if (cells.size() != 2)
        return TableError{Reason::notTwoNumbers, line, {}};
    return Point{numbers[0], numbers[1]};
}

std::variant<Points, TableError> pointsOf(const std::vector<Line>& lines, const QRegularExpression& separator) {
    Points points;
    for (const Line& line : lines) {
        const auto point = pointOf(line.text.split(separator), line.number);
        if (const TableError* error = std::get_if<TableError>(&point))
            return *error;
        points.push_back(std::get<Point>(point));
    }
    return points;
}

std::vector<Line> linesOf(const QString& text) {
    std::vector<Line> lines;
    int number = 0;
    for (const QStringView line : QStringView(text).split(QLatin1Char('\n'))) {
        ++number;
        if (const QStringView trimmed = line.trimmed(); !trimmed.isEmpty())
            lines.push_back({trimmed.toString(), number});
        if (lines.size() > limits::kPointsInCurve)
            break;
    }
    return lines;
}

class TableErrors {
    Q_DECLARE_TR_FUNCTIONS(TableErrors)
  public:
    static QString text(const TableError& error) {
        switch (error.reason) {
        case Reason::empty:
            return tr("The clipboard holds no points");
        case Reason::tooManyPoints:
            return tr("The clipboard: more than %1 points are too many for a curve").arg(limits::kPointsInCurve);
        case Reason::notTwoNumbers:
            return tr("The clipboard, line %1: expected two numbers").arg(error.line);
        case Reason::noNumber:
            return tr("The clipboard, line %1: “%2” is no number").arg(error.line).arg(told(error.cell));
        case Reason::outOfRange:
            return tr("The clipboard, line %1: “%2” is not from %3 to %4")
                .arg(QString::number(error.line), told(error.cell), formatNumber(-limits::kNumber),
                     formatNumber(limits::kNumber));
        }
        return {};
    }

  private:
    static QString told(const QString& cell) {
        return cell.size() <= kLongestCell ? cell : cell.left(kLongestCell) + QChar(u'…');
    }
};

} // namespace

QString pointsTable(const Points& points) {
    QStringList lines;
    for (const Point p : points)
        lines.append(formatNumber(p.x) + QLatin1Char('\t') + formatNumber(p.y));
    return lines.join(QLatin1Char('\n'));
}

std::variant<Points, TableError> readPointsTable(const QString& text) {
    static const QRegularExpression wideSeparator(QStringLiteral("\\s*[\\t;]\\s*|\\s+"));
    static const QRegularExpression comma(QStringLiteral(","));
    const std::vector<Line> lines = linesOf(text);
    if (lines.empty())
        return TableError{};
    if (lines.size() > limits::kPointsInCurve)
        return TableError{Reason::tooManyPoints, 0, {}};
    // One way of reading for the whole table: a comma is the decimal sign in all lines or the separator in all.
    auto wide = pointsOf(lines, wideSeparator);
    if (std::holds_alternative<Points>(wide))
        return wide;
    auto narrow = pointsOf(lines, comma);
    if (std::holds_alternative<Points>(narrow))
        return narrow;
    // What is told is the fault in the way of reading that came further.
    return std::get<TableError>(narrow).line > std::get<TableError>(wide).line ? narrow : wide;
}

QString errorText(const TableError& error) {
    return TableErrors::text(error);
}

} // namespace kriva::ui
