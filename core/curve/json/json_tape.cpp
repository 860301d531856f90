#include "core/curve/json/json_tape.h"

#include "core/curve/limits.h"
#include "core/curve/text/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>

namespace kriva {
namespace {

/// The nearest double of a number of JSON: zero where it is too small for one, infinite where it is too large.
double nearestDouble(std::string_view token) {
    double value = 0;
    if (std::from_chars(token.data(), token.data() + token.size(), value).ec == std::errc())
        return value;
    // It is far from 1: the power of ten of the first digit but 0 tells on which side.
    const std::size_t end = std::min(token.find_first_of("eE"), token.size());
    const std::size_t point = std::min(token.find('.'), end);
    std::string_view exponent = token.substr(std::min(end + 1, token.size()));
    if (exponent.starts_with('+'))
        exponent.remove_prefix(1);
    int power = 0;
    if (std::from_chars(exponent.data(), exponent.data() + exponent.size(), power).ec == std::errc::result_out_of_range)
        power = exponent.starts_with('-') ? -limits::kNumberCharacters : limits::kNumberCharacters;
    power += static_cast<int>(point) - static_cast<int>(token.find_first_of("123456789"));
    value = power > 0 ? std::numeric_limits<double>::infinity() : 0;
    return token.starts_with('-') ? -value : value;
}

void appendCharacter(std::string& to, char32_t c) {
    constexpr std::array<char32_t, 4> kLead{0, 0xc0, 0xe0, 0xf0};
    const std::size_t rest = c < 0x80 ? 0 : c < 0x800 ? 1 : c < 0x10000 ? 2 : 3; // bytes behind the first one
    to += static_cast<char>(kLead[rest] | c >> 6 * rest);
    for (std::size_t i = rest; i-- > 0;)
        to += static_cast<char>(0x80 | (c >> 6 * i & 0x3f));
}

/// Lays a text on a tape. Each function that reads goes on behind what it read; it gives false where there is a fault,
/// at the first byte that cannot stand there unless error_ says otherwise.
class JsonReader {
  public:
    explicit JsonReader(std::string_view text)
        : text_(text) {}

    [[nodiscard]] std::variant<JsonTape, FileError> read() && {
        if (readValue() && !isMore())
            return std::move(tape_);
        return error_ ? *std::move(error_) : errorAtByte(FileProblem::notJson, text_, at_);
    }

  private:
    bool skip(std::string_view oneOf) {
        const bool isNext = at_ < text_.size() && oneOf.find(text_[at_]) != std::string_view::npos;
        at_ += isNext ? 1 : 0;
        return isNext;
    }
    bool skipDigits() {
        const std::size_t start = at_;
        at_ = std::min(text_.find_first_not_of("0123456789", at_), text_.size());
        return at_ > start;
    }
    /// Whether anything stands behind the blanks that come next.
    bool isMore() {
        at_ = std::min(text_.find_first_not_of(" \n\r\t", at_), text_.size());
        return at_ < text_.size();
    }
    bool skipBehindBlanks(std::string_view c) { return isMore() && skip(c); }

    bool add(JsonKind kind, double number = 0) {
        JsonEntry& entry = tape_.entries.emplace_back();
        entry.number = number;
        entry.kind = kind;
        entry.next = static_cast<std::uint32_t>(tape_.entries.size());
        return true;
    }
    bool refuse(FileProblem problem, int limit, std::size_t byte) {
        error_ = errorAtByte(problem, text_, byte);
        error_->numbers = {static_cast<double>(limit)};
        return false;
    }

    bool readValue() {
        if (!isMore())
            return false;
        switch (text_[at_]) {
        case '{':
            return readMembers(JsonKind::object, "}");
        case '[':
            return readMembers(JsonKind::list, "]");
        default:
            return readScalar();
        }
    }
    bool readMembers(JsonKind kind, std::string_view end) {
        if (++depth_ > limits::kNesting)
            return refuse(FileProblem::nestedTooDeep, limits::kNesting, at_);
        ++at_;
        const std::size_t index = tape_.entries.size();
        add(kind);
        bool isAtEnd = skipBehindBlanks(end);
        while (!isAtEnd) {
            if ((kind == JsonKind::object && !readKey()) || !readValue())
                return false;
            isAtEnd = skipBehindBlanks(end);
            if (!isAtEnd && !skip(","))
                return false;
        }
        --depth_;
        tape_.entries[index].next = static_cast<std::uint32_t>(tape_.entries.size());
        return true;
    }
    /// A word or a number in its place is read to its end.
    bool readKey() {
        return isMore() && readScalar() && tape_.entries.back().kind == JsonKind::text && skipBehindBlanks(":");
    }
    bool readScalar() {
        switch (text_[at_]) {
        case '"':
            return readText();
        case 'n':
            return readWord("null") && add(JsonKind::null);
        case 't':
            return readWord("true") && add(JsonKind::boolean, 1);
        case 'f':
            return readWord("false") && add(JsonKind::boolean, 0);
        default:
            return readNumber();
        }
    }
    bool readWord(std::string_view word) {
        return std::ranges::all_of(word, [this](const char& c) { return skip({&c, 1}); });
    }
    bool readNumber() {
        const std::size_t start = at_;
        skip("-");
        if (!skip("0") && !skipDigits())
            return false;
        if (skip(".") && !skipDigits())
            return false;
        if (skip("eE") && (skip("+-"), !skipDigits()))
            return false;
        if (at_ - start > static_cast<std::size_t>(limits::kNumberCharacters))
            return refuse(FileProblem::numberTooLong, limits::kNumberCharacters, start);
        return add(JsonKind::number, nearestDouble(text_.substr(start, at_ - start)));
    }
    bool readText() {
        const std::size_t start = tape_.texts.size();
        ++at_;
        while (!skip("\""))
            if (!(skip("\\") ? readEscape() : readCharacter()))
                return false;
        add(JsonKind::text);
        tape_.entries.back().text = {static_cast<std::uint32_t>(start),
                                     static_cast<std::uint32_t>(tape_.texts.size() - start)};
        return true;
    }
    bool readCharacter() {
        if (at_ == text_.size())
            return false;
        const Utf8Character character = firstCharacter(text_.substr(at_));
        if (character.codePoint.value_or(0) < U' ')
            return false;
        tape_.texts += character.bytes;
        at_ += character.bytes.size();
        return true;
    }
    bool readEscape() {
        constexpr std::string_view kLetters = "\"\\/bfnrt";
        constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
        if (skip(kLetters)) {
            tape_.texts += kMeanings[kLetters.find(text_[at_ - 1])];
            return true;
        }
        std::uint32_t c = 0;
        if (!skip("u") || !readCodeUnit(c))
            return false;
        if (c >= 0xd800 && c < 0xdc00) {
            std::uint32_t low = 0;
            if (!skip("\\") || !skip("u") || !readCodeUnit(low) || low < 0xdc00 || low >= 0xe000)
                return false;
            c = 0x10000 + (c - 0xd800) * 0x400 + (low - 0xdc00);
        } else if (c >= 0xdc00 && c < 0xe000) {
            return false;
        }
        appendCharacter(tape_.texts, c);
        return true;
    }
    bool readCodeUnit(std::uint32_t& unit) {
        const std::string_view digits = text_.substr(at_, 4);
        const char* const end = digits.data() + digits.size();
        at_ += digits.size();
        return digits.size() == 4 && std::from_chars(digits.data(), end, unit, 16).ptr == end;
    }

    std::string_view text_;
    std::size_t at_ = 0; ///< where it goes on
    int depth_ = 0;
    JsonTape tape_;
    std::optional<FileError> error_;
};

} // namespace

std::string_view textOf(const JsonTape& tape, std::uint32_t index) {
    const auto text = tape.entries[index].text;
    return std::string_view(tape.texts).substr(text.offset, text.size);
}

std::variant<JsonTape, FileError> parseJson(std::string_view text) {
    if (text.size() > limits::kFileBytes)
        return errorOfFile(FileProblem::tooLarge, {static_cast<double>(limits::kFileBytes)});
    return JsonReader(text).read();
}

} // namespace kriva
