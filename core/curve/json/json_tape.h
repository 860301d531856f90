#pragma once

#include "core/curve/file_error.h"

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <variant>

namespace kriva {

enum class JsonKind : std::uint8_t { null, boolean, number, text, list, object };

/// Where a text stands among the texts of a tape.
struct JsonTextRange {
    std::uint32_t offset;
    std::uint32_t size;
};

/// One value of a tape. The members of a list follow it; those of an object follow it as text, value, text, value.
struct JsonEntry {
    union {
        double number;
        JsonTextRange text;
    };
    std::uint32_t next = 0; ///< where the entry behind this value and all its members stands
    JsonKind kind = JsonKind::null;
};

/// A parsed JSON text as one flat list of values in the order of the text: 16 bytes a value, and no more while it
/// grows, so that any file within the limits stays within memory.
struct JsonTape {
    std::deque<JsonEntry> entries;
    std::string texts;
};

/// The text or key that stands at an index of the tape.
[[nodiscard]] std::string_view textOf(const JsonTape& tape, std::uint32_t index);

/// Reads strict JSON (RFC 8259) in UTF-8 without a byte order mark, at most kFileBytes long and 64 levels deep, with
/// numbers of at most 1,000 characters; refuses anything else with line and column. Numbers are the nearest doubles,
/// whatever the process's locale: -0 keeps its sign, and what is beyond the range of doubles is infinite, which
/// JsonNode refuses with its place.
[[nodiscard]] std::variant<JsonTape, FileError> parseJson(std::string_view text);

} // namespace kriva
