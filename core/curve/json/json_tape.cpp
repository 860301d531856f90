#include "core/curve/json/json_tape.h"

#include "core/curve/limits.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <locale.h> // newlocale and uselocale: POSIX, not in <clocale>
#include <optional>

namespace kriva {
namespace {

/// Makes the C library read a point as the decimal sign in this thread: the library below asks it for numbers, and
/// would take a valid number for a wrong one where the process's locale has another sign.
class PointLocale {
  public:
    PointLocale()
        : point_(newlocale(LC_NUMERIC_MASK, "C", nullptr))
        , before_(uselocale(point_)) {}
    ~PointLocale() {
        uselocale(before_);
        freelocale(point_);
    }
    PointLocale(const PointLocale&) = delete;
    PointLocale& operator=(const PointLocale&) = delete;

  private:
    locale_t point_;
    locale_t before_;
};

bool isBlank(char c) {
    return c == ' ' || c == '\n' || c == '\r' || c == '\t';
}

/// A place in a JSON text, whose line ends and tabs outside of texts are read as blanks. The library writes all that it
/// skipped into a message, which nobody reads, and eight characters for each that is no blank: a GiB for a file of
/// them.
class BlankedPlace {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = char;

    explicit BlankedPlace(const char* at)
        : at_(at) {}

    char operator*() const { return !isInText_ && isBlank(*at_) ? ' ' : *at_; }
    BlankedPlace& operator++() {
        if (*at_ == '"' && !isEscaped_)
            isInText_ = !isInText_;
        isEscaped_ = isInText_ && *at_ == '\\' && !isEscaped_;
        ++at_;
        return *this;
    }
    friend bool operator==(const BlankedPlace& a, const BlankedPlace& b) { return a.at_ == b.at_; }

  private:
    const char* at_;
    bool isInText_ = false;
    bool isEscaped_ = false;
};

struct Outline {
    std::size_t entries = 1; ///< values and keys, if the text is JSON
    std::optional<FileError> error;
};

FileError beyondLimit(FileProblem problem, int limit, std::string_view text, std::size_t byte) {
    FileError error = errorAtByte(problem, text, byte);
    error.numbers = {static_cast<double>(limit)};
    return error;
}

bool startsNumber(char c) {
    return c == '-' || ('0' <= c && c <= '9');
}

/// Counts entries without parsing, by brackets, commas and colons outside texts, and sees what would take the parser
/// too deep or too long.
Outline outlineOf(std::string_view text) {
    Outline outline;
    int depth = 0;
    bool isInText = false;
    char before = 0;       // blanks left out
    std::size_t token = 0; // where the number or word that goes on here began
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (isInText) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                isInText = false;
            token = i + 1;
            continue;
        }
        if (isBlank(c)) {
            token = i + 1;
            continue;
        }
        const bool isOpening = c == '[' || c == '{';
        const bool isClosing = c == ']' || c == '}';
        const bool isDivider = c == ',' || c == ':';
        if (isDivider || ((before == '[' || before == '{') && !isClosing))
            ++outline.entries;
        if (isOpening && ++depth > limits::kNesting) {
            outline.error = beyondLimit(FileProblem::nestedTooDeep, limits::kNesting, text, i);
            break;
        }
        if (isClosing)
            --depth;
        isInText = c == '"';
        if (isOpening || isClosing || isDivider || isInText)
            token = i + 1;
        else if (i - token == limits::kNumberCharacters && startsNumber(text[token])) {
            outline.error = beyondLimit(FileProblem::numberTooLong, limits::kNumberCharacters, text, token);
            break;
        }
        before = c;
    }
    return outline;
}

/// Receives nlohmann's events and lays them on the tape.
class TapeBuilder {
  public:
    explicit TapeBuilder(JsonTape& tape)
        : tape_(tape) {}

    bool null() { return add(JsonKind::null, 0); }
    bool boolean(bool value) { return add(JsonKind::boolean, value ? 1 : 0); }
    // The library calls this for tokens with a sign only: its integer 0 was "-0".
    bool number_integer(std::int64_t value) {
        return add(JsonKind::number, value == 0 ? -0.0 : static_cast<double>(value));
    }
    bool number_unsigned(std::uint64_t value) { return add(JsonKind::number, static_cast<double>(value)); }
    bool number_float(double value, const std::string& token) {
        // Leaves the library's value where the token is too small for it.
        std::from_chars(token.data(), token.data() + token.size(), value);
        return add(JsonKind::number, value);
    }
    bool string(const std::string& value) {
        JsonEntry entry;
        entry.text = {static_cast<std::uint32_t>(tape_.texts.size()), static_cast<std::uint32_t>(value.size())};
        entry.kind = JsonKind::text;
        entry.next = nextIndex() + 1;
        tape_.texts += value;
        tape_.entries.push_back(entry);
        return true;
    }
    bool key(const std::string& value) { return string(value); }
    bool start_object(std::size_t) { return open(JsonKind::object); }
    bool start_array(std::size_t) { return open(JsonKind::list); }
    bool end_object() { return close(); }
    bool end_array() { return close(); }
    // Binary values exist in other formats of the library only.
    bool binary(const nlohmann::json::binary_t&) { return false; }
    bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& error) {
        constexpr int kNumberOverflow = 406; // of the library's documentation
        errorByte_ = byte;
        isOverflow_ = error.id == kNumberOverflow;
        return false;
    }

    /// Why the library stopped: a number beyond the range of doubles is JSON, and so has a place.
    [[nodiscard]] FileError error(std::string_view text) const {
        if (!isOverflow_)
            return errorAtByte(FileProblem::notJson, text, std::max<std::size_t>(errorByte_, 1) - 1);
        FileError error;
        error.problem = FileProblem::numberOutOfRange;
        error.place = placeOfNext();
        error.numbers = {-limits::kNumber, limits::kNumber};
        return error;
    }

  private:
    [[nodiscard]] std::uint32_t nextIndex() const { return static_cast<std::uint32_t>(tape_.entries.size()); }
    bool add(JsonKind kind, double number) {
        JsonEntry entry;
        entry.number = number;
        entry.kind = kind;
        entry.next = nextIndex() + 1;
        tape_.entries.push_back(entry);
        return true;
    }
    /// The place of the value that would come next.
    [[nodiscard]] std::string placeOfNext() const {
        std::string place;
        for (std::size_t depth = 0; depth < open_.size(); ++depth) {
            const std::uint32_t end = depth + 1 < open_.size() ? open_[depth + 1] : nextIndex();
            if (tape_.entries[open_[depth]].kind == JsonKind::object) {
                appendKey(place, textOf(tape_, end - 1));
                continue;
            }
            std::size_t position = 0;
            for (std::uint32_t i = open_[depth] + 1; i < end; i = tape_.entries[i].next)
                ++position;
            appendPosition(place, position);
        }
        return place;
    }
    bool open(JsonKind kind) {
        open_.push_back(nextIndex());
        return add(kind, 0);
    }
    bool close() {
        tape_.entries[open_.back()].next = nextIndex();
        open_.pop_back();
        return true;
    }

    JsonTape& tape_;
    std::vector<std::uint32_t> open_;
    std::size_t errorByte_ = 0;
    bool isOverflow_ = false;
};

} // namespace

std::string_view textOf(const JsonTape& tape, std::uint32_t index) {
    const auto text = tape.entries[index].text;
    return std::string_view(tape.texts).substr(text.offset, text.size);
}

std::variant<JsonTape, FileError> parseJson(std::string_view text) {
    if (text.size() > limits::kFileBytes)
        return errorOfFile(FileProblem::tooLarge, {static_cast<double>(limits::kFileBytes)});
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; // the library would take it in silence
    if (text.starts_with(kByteOrderMark))
        return errorAtByte(FileProblem::notJson, text, 0);
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos) // and this for the end
        return errorAtByte(FileProblem::notJson, text, nul);
    const Outline outline = outlineOf(text);
    if (outline.error)
        return *outline.error;
    JsonTape tape;
    // Whatever a text that is no JSON says: an entry takes at least two bytes, itself and what divides it from the
    // next.
    tape.entries.reserve(std::min(outline.entries, text.size() / 2 + 1));
    TapeBuilder builder(tape);
    const PointLocale pointLocale;
    if (!nlohmann::json::sax_parse(BlankedPlace(text.data()), BlankedPlace(text.data() + text.size()), &builder))
        return builder.error(text);
    return tape;
}

} // namespace kriva
