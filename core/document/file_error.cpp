#include "core/document/file_error.h"

#include <algorithm>

namespace kriva {

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
