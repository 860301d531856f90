#include "core/io/tables/table_writer.h"

#include "core/figure/labels.h"
#include "core/io/latex/latex_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace kriva {
namespace {

template <class... Visitors>
struct Overloaded : Visitors... {
    using Visitors::operator()...;
};
template <class... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

std::string shortest(double number) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

std::string rangeText(IndexRange range) {
    return decimal(range.first) + "–" + decimal(range.last);
}

/// "B_0" as a spreadsheet has it.
std::string nameOf(const TableColumn& column, const TextSource& texts) {
    if (column.caption != Caption::none)
        return texts.translate(column.caption) + (column.index.empty() ? "" : " " + column.index);
    return column.letter + column.index;
}

/// The coordinates of a point or a vector.
std::optional<Vector> pairOf(const TableCell& cell) {
    if (const Point* point = std::get_if<Point>(&cell.value))
        return *point - Point{};
    const Vector* vector = std::get_if<Vector>(&cell.value);
    return vector ? std::optional(*vector) : std::nullopt;
}

std::string plainCell(const TableCell& cell, const TextSource& texts) {
    return std::visit(Overloaded{[](double v) { return shortest(v); }, [](int v) { return decimal(v); },
                                 [](IndexRange v) { return rangeText(v); },
                                 [&](Caption v) { return texts.translate(v); },
                                 [](const auto&) { return std::string(); }},
                      cell.value);
}

/// A pair takes two fields, and so do all cells of its column.
void addFields(std::vector<std::string>& fields, const TableCell& cell, bool hasPairs, const TextSource& texts) {
    if (const std::optional<Vector> pair = pairOf(cell)) {
        fields.push_back(shortest(pair->x));
        fields.push_back(shortest(pair->y));
        return;
    }
    fields.push_back(plainCell(cell, texts));
    if (hasPairs)
        fields.emplace_back();
}

/// Quoted as RFC 4180 asks for, where it needs it.
std::string field(const std::string& text, char separator) {
    if (text.find_first_of(std::string("\"\n\r") + separator) == std::string::npos)
        return text;
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c;
        if (c == '"')
            quoted += c;
    }
    return quoted + '"';
}

void addRecord(std::string& text, const std::vector<std::string>& fields, char separator) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i > 0)
            text += separator;
        text += field(fields[i], separator);
    }
    text += '\n';
}

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
}

/// The fewest decimals that tell six significant digits.
int significantDecimals(double value) {
    constexpr double kSixDigits = 5e-7;
    constexpr int kMost = 17;
    int decimals = 0;
    for (double scale = 1; decimals < kMost; ++decimals, scale *= 10)
        if (std::abs(std::round(value * scale) / scale - value) <= kSixDigits * std::abs(value))
            break;
    return decimals;
}

/// Between the dollars of a formula.
std::string latexNumber(double value, const TextSource& texts) {
    if (!std::isfinite(value))
        return "";
    constexpr double kPlainLow = 1e-4;
    constexpr double kPlainHigh = 1e6;
    const double size = std::abs(value);
    const int exponent =
        size == 0 || (size >= kPlainLow && size < kPlainHigh) ? 0 : static_cast<int>(std::floor(std::log10(size)));
    const double mantissa = value / std::pow(10, exponent);
    std::string text = texts.number(mantissa, significantDecimals(mantissa));
    replaceAll(text, "\u2212", "-");
    replaceAll(text, ",", "{,}"); // a comma of a number has no room behind it
    return exponent == 0 ? text : text + " \\cdot 10^{" + shortest(exponent) + "}";
}

std::string latexPair(Vector p, const TextSource& texts) {
    return std::string("(").append(latexNumber(p.x, texts)).append(";\\ ").append(latexNumber(p.y, texts)).append(")");
}

std::string latexCell(const TableCell& cell, const TextSource& texts) {
    const auto formula = [&](const std::string& text) {
        return text.empty() ? text : cell.isBest ? "$\\mathbf{" + text + "}$" : "$" + text + "$";
    };
    const auto words = [&](const std::string& text) {
        return cell.isBest ? std::string("\\textbf{").append(latexText(text)).append("}") : latexText(text);
    };
    if (const std::optional<Vector> pair = pairOf(cell))
        return formula(latexPair(*pair, texts));
    return std::visit(
        Overloaded{[&](double v) { return formula(latexNumber(v, texts)); }, [&](int v) { return formula(decimal(v)); },
                   [&](IndexRange v) { return words(rangeText(v)); },
                   [&](Caption v) { return words(texts.translate(v)); }, [](const auto&) { return std::string(); }},
        cell.value);
}

std::string latexName(const TableColumn& column, const TextSource& texts) {
    if (column.caption != Caption::none)
        return latexText(nameOf(column, texts));
    if (column.letter.empty())
        return "";
    return "$" + column.letter + (column.index.empty() ? "" : "_{" + column.index + "}") + "$";
}

void addLatexRow(std::string& text, const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i)
        text.append(i > 0 ? " & " : "").append(cells[i]);
    text += " \\\\\n";
}

bool hasPairs(const Table& table, std::size_t column) {
    return std::ranges::any_of(table.rows, [&](const auto& row) { return pairOf(row[column]).has_value(); });
}

bool isNumber(const TableCell& cell) {
    return std::holds_alternative<double>(cell.value) || std::holds_alternative<int>(cell.value);
}

/// Numbers to the right, words to the left.
std::string alignments(const Table& table) {
    std::string letters;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const bool hasNumbers = std::ranges::any_of(table.rows, [&](const auto& row) { return isNumber(row[i]); });
        letters += hasNumbers ? 'r' : 'l';
    }
    return letters;
}

} // namespace

std::string writeDelimited(const Table& table, const TextSource& texts, char separator) {
    std::string text;
    std::vector<std::string> fields;
    std::vector<bool> isOfPairs; // of each column: every row would be looked through again for each field
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const std::string name = nameOf(table.columns[i], texts);
        isOfPairs.push_back(hasPairs(table, i));
        if (isOfPairs[i])
            fields.insert(fields.end(), {name + " x", name + " y"});
        else
            fields.push_back(name);
    }
    addRecord(text, fields, separator);
    for (const std::vector<TableCell>& row : table.rows) {
        fields.clear();
        for (std::size_t i = 0; i < row.size(); ++i)
            addFields(fields, row[i], isOfPairs[i], texts);
        addRecord(text, fields, separator);
    }
    return text;
}

std::string writeLatex(const Table& table, const TextSource& texts) {
    std::string text = std::string("\\begin{tabular}{").append(alignments(table)).append("}\n\\hline\n");
    std::vector<std::string> cells;
    for (const TableColumn& column : table.columns)
        cells.push_back(latexName(column, texts));
    addLatexRow(text, cells);
    text += "\\hline\n";
    for (const std::vector<TableCell>& row : table.rows) {
        cells.clear();
        for (const TableCell& cell : row)
            cells.push_back(latexCell(cell, texts));
        addLatexRow(text, cells);
    }
    return text + "\\hline\n\\end{tabular}\n";
}

} // namespace kriva
