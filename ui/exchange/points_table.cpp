#include "ui/exchange/points_table.h"

#include "core/document/limits.h"
#include "ui/shell/language/number_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

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

/// A line: the number of its curve, 0 where it has none, and its point.
struct PointOfCurve {
    double curve = 0;
    Point at;
};

constexpr qsizetype kColumns = 2;
constexpr qsizetype kOwnColumns = 4; // curve, point, x, y

std::variant<PointOfCurve, TableError> pointOf(const QStringList& cells, qsizetype columns, int line) {
    std::array<double, kOwnColumns> numbers{};
    for (qsizetype i = 0; i < std::min(columns, cells.size()); ++i) {
        const auto read = coordinate(cells[i], line);
        if (const TableError* error = std::get_if<TableError>(&read))
            return *error;
        numbers[static_cast<std::size_t>(i)] = std::get<double>(read);
    }
    if (cells.size() != columns)
        return TableError{Reason::notTwoNumbers, line, {}};
    if (columns == kColumns)
        return PointOfCurve{0, {numbers[0], numbers[1]}};
    return PointOfCurve{numbers[0], {numbers[2], numbers[3]}};
}

bool isHeading(const QStringList& cells) {
    return cells.size() > 1 && std::none_of(cells.begin(), cells.end(), [](const QString& cell) {
               return cell.isEmpty() || parseNumber(cell).has_value();
           });
}

std::variant<std::vector<Points>, TableError> pointsOf(std::span<const Line> lines,
                                                       const QRegularExpression& separator) {
    qsizetype columns = kColumns;
    const QStringList first = lines.front().text.split(separator);
    if (lines.size() > 1 && isHeading(first)) {
        lines = lines.subspan(1);
        columns = first.size() == kOwnColumns ? kOwnColumns : kColumns;
    }
    std::vector<Points> curves;
    std::optional<double> curve;
    for (const Line& line : lines) {
        const auto read = pointOf(line.text.split(separator), columns, line.number);
        if (const TableError* error = std::get_if<TableError>(&read))
            return *error;
        const PointOfCurve& point = std::get<PointOfCurve>(read);
        if (std::exchange(curve, point.curve) != point.curve)
            curves.emplace_back();
        curves.back().push_back(point.at);
    }
    return curves;
}

std::vector<Line> linesOf(const QString& text) {
    std::vector<Line> lines;
    int number = 0;
    for (const QStringView line : QStringView(text).split(QLatin1Char('\n'))) {
        ++number;
        if (const QStringView trimmed = line.trimmed(); !trimmed.isEmpty())
            lines.push_back({trimmed.toString(), number});
        if (lines.size() > limits::kPointsInSheet)
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
            return tr("there are no points");
        case Reason::tooManyPoints:
            return tr("more than %1 points are too many").arg(limits::kPointsInSheet);
        case Reason::notTwoNumbers:
            return tr("line %1: expected two numbers").arg(error.line);
        case Reason::noNumber:
            return tr("line %1: “%2” is no number").arg(error.line).arg(told(error.cell));
        case Reason::outOfRange:
            return tr("line %1: “%2” is not from %3 to %4")
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

std::variant<std::vector<Points>, TableError> readPointsTable(const QString& text) {
    static const QRegularExpression wideSeparator(QStringLiteral("\\s*[\\t;]\\s*|\\s+"));
    static const QRegularExpression comma(QStringLiteral(","));
    const std::vector<Line> lines = linesOf(text);
    if (lines.empty())
        return TableError{};
    if (lines.size() > limits::kPointsInSheet)
        return TableError{Reason::tooManyPoints, 0, {}};
    // One way of reading for the whole table: a comma is the decimal sign in all lines or the separator in all.
    auto wide = pointsOf(lines, wideSeparator);
    if (std::holds_alternative<std::vector<Points>>(wide))
        return wide;
    auto narrow = pointsOf(lines, comma);
    if (std::holds_alternative<std::vector<Points>>(narrow))
        return narrow;
    // What is told is the fault in the way of reading that came further.
    return std::get<TableError>(narrow).line > std::get<TableError>(wide).line ? narrow : wide;
}

QString errorText(const TableError& error) {
    return TableErrors::text(error);
}

} // namespace kriva::ui
