#include "core/io/tables/points_reader.h"

#include "core/curve/limits.h"
#include "core/curve/text/utf8.h"
#include "core/io/numbers/typed_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace kriva {
namespace {

/// What stands between the cells of a table.
enum class Separator {
    wide,  ///< blanks, with one semicolon or without: commas are decimal signs
    comma, ///< commas alone
};

constexpr std::string_view kAsciiBlanks = " \t\v\f\r";

/// The cells of one line, one after the other.
class Cells {
  public:
    /// The line has no blanks at its ends.
    Cells(std::string_view line, Separator separator)
        : rest_(line)
        , separator_(separator) {}

    [[nodiscard]] bool isAtEnd() const { return isAtEnd_; }
    /// Of a line that is not at its end.
    std::string_view next() {
        const std::size_t end = rest_.find_first_of(separator_ == Separator::comma ? "," : " \t\v\f\r;");
        const std::string_view cell = rest_.substr(0, end);
        isAtEnd_ = end == std::string_view::npos;
        rest_.remove_prefix(cell.size());
        if (!isAtEnd_)
            skipSeparator();
        return cell;
    }

  private:
    void skipSeparator() {
        if (separator_ == Separator::comma)
            return rest_.remove_prefix(1);
        skipBlanks();
        if (rest_.starts_with(';'))
            rest_.remove_prefix(1);
        skipBlanks();
    }
    void skipBlanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(kAsciiBlanks), rest_.size())); }

    std::string_view rest_;
    Separator separator_;
    bool isAtEnd_ = false;
};

constexpr std::size_t kColumns = 2;
constexpr std::size_t kOwnColumns = 4; // curve, point, x, y

/// Reads a whole table in one way: a comma is the decimal sign in all its lines or the separator in all.
class TableReader {
  public:
    TableReader(std::string_view text, Separator separator)
        : text_(text)
        , separator_(separator) {}

    [[nodiscard]] std::variant<std::vector<Points>, TableError> read() &&;

  private:
    /// Goes on to the next line that says something; false where there is none.
    bool nextLine();
    /// How many columns a line names; nothing where it names none.
    [[nodiscard]] std::optional<std::size_t> namedColumns() const;
    // These give false where there is a fault.
    bool readLine();
    bool readNumber(std::string_view cell, double& number);
    bool add(double curve, Point at);
    bool refuse(TableProblem problem, std::string_view cell, bool isTold = true);

    std::string_view text_;
    Separator separator_;
    std::size_t at_ = 0;    ///< where the next line begins
    std::string_view line_; ///< the present one, without blanks at its ends
    std::size_t columns_ = kColumns;
    char decimalSign_ = 0;        ///< of the first number that has one
    std::optional<double> curve_; ///< what the first of four columns calls the present one
    std::vector<Points> curves_;
    std::size_t points_ = 0;
    TableError error_;
};

bool TableReader::nextLine() {
    while (at_ < text_.size()) {
        const std::size_t end = std::min(text_.find('\n', at_), text_.size());
        line_ = withoutOuterBlanks(text_.substr(at_, end - at_));
        at_ = end + 1;
        if (!line_.empty())
            return true;
    }
    return false;
}

std::optional<std::size_t> TableReader::namedColumns() const {
    std::size_t count = 0;
    for (Cells cells(line_, separator_); !cells.isAtEnd(); ++count)
        if (const std::string_view cell = cells.next(); cell.empty() || readTypedNumber(cell))
            return {};
    return count > 1 ? std::optional(count) : std::nullopt;
}

bool TableReader::refuse(TableProblem problem, std::string_view cell, bool isTold) {
    constexpr int kLongestCell = 20; // characters
    const std::string_view before = text_.substr(0, static_cast<std::size_t>(cell.data() - text_.data()));
    const std::size_t lineStart = before.rfind('\n') + 1; // 0 where there is none
    error_ = {problem,
              static_cast<int>(std::ranges::count(before, '\n')) + 1,
              static_cast<int>(before.size() - lineStart) + 1,
              {}};
    for (int i = 0; isTold && !cell.empty(); ++i) {
        const std::string_view character = firstCharacter(cell).bytes;
        error_.cell += i < kLongestCell ? character : "…";
        cell = i < kLongestCell ? cell.substr(character.size()) : std::string_view();
    }
    return false;
}

bool TableReader::readNumber(std::string_view cell, double& number) {
    const std::optional<TypedNumber> typed = readTypedNumber(cell);
    if (!typed)
        return refuse(TableProblem::noNumber, cell);
    if (std::abs(typed->value) > limits::kNumber)
        return refuse(TableProblem::outOfRange, cell);
    if (decimalSign_ == 0)
        decimalSign_ = typed->decimalSign;
    if (typed->decimalSign != 0 && typed->decimalSign != decimalSign_)
        return refuse(TableProblem::mixedDecimals, cell);
    number = typed->value;
    return true;
}

bool TableReader::add(double curve, Point at) {
    if (++points_ > limits::kPointsInSheet)
        return refuse(TableProblem::tooManyPoints, line_, false);
    if (std::exchange(curve_, curve) != curve)
        curves_.emplace_back();
    if (curves_.back().size() == limits::kPointsInCurve)
        return refuse(TableProblem::tooManyPointsInCurve, line_, false);
    curves_.back().push_back(at);
    return true;
}

bool TableReader::readLine() {
    std::array<double, kOwnColumns> numbers{};
    Cells cells(line_, separator_);
    for (std::size_t i = 0; i < columns_; ++i) {
        if (cells.isAtEnd())
            return refuse(TableProblem::notTwoNumbers, line_, false);
        if (!readNumber(cells.next(), numbers[i]))
            return false;
    }
    if (!cells.isAtEnd())
        return refuse(TableProblem::notTwoNumbers, cells.next(), false);
    return columns_ == kColumns ? add(0, {numbers[0], numbers[1]}) : add(numbers[0], {numbers[2], numbers[3]});
}

std::variant<std::vector<Points>, TableError> TableReader::read() && {
    if (!nextLine())
        return TableError{};
    if (const std::optional<std::size_t> named = namedColumns()) {
        const std::string_view heading = line_;
        if (nextLine())
            columns_ = *named == kOwnColumns ? kOwnColumns : kColumns;
        else
            line_ = heading; // nothing stands below: it is the table, and refused
    }
    do
        if (!readLine())
            return std::move(error_);
    while (nextLine());
    return std::move(curves_);
}

} // namespace

std::variant<std::vector<Points>, TableError> readPointsTable(std::string_view text) {
    auto wide = TableReader(text, Separator::wide).read();
    if (std::holds_alternative<std::vector<Points>>(wide))
        return wide;
    auto narrow = TableReader(text, Separator::comma).read();
    if (std::holds_alternative<std::vector<Points>>(narrow))
        return narrow;
    // What is told is the fault in the way of reading that came further.
    return std::get<TableError>(narrow).line > std::get<TableError>(wide).line ? narrow : wide;
}

} // namespace kriva
