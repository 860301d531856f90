#include "core/curve/file_error.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace kriva {

void appendKey(std::string& place, std::string_view key) {
    if (!place.empty())
        place += '.';
    // Without a letter it would be no place at all.
    place += key.empty() ? std::string_view("\"\"") : key;
}

void appendPosition(std::string& place, std::size_t position) {
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, position).ptr;
    place.append("[").append(digits, end).append("]");
}

FileError errorOfFile(FileProblem problem, std::vector<double> numbers) {
    FileError error;
    error.problem = problem;
    error.numbers = std::move(numbers);
    return error;
}

std::optional<FileError> pointCountError(std::size_t points, std::size_t most) {
    if (points <= most)
        return {};
    return errorOfFile(FileProblem::tooManyPointsInCurve, {static_cast<double>(most), static_cast<double>(points)});
}

FileError errorAtByte(FileProblem problem, std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto lineStart = before.rfind('\n') + 1; // npos + 1 is 0: the first line
    FileError error;
    error.problem = problem;
    error.line = static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1;
    error.column = static_cast<int>(before.size() - lineStart) + 1;
    return error;
}

} // namespace kriva
