#include "core/document/json_tape.h"

#include "core/document/limits.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>

namespace kriva {
namespace {

struct Outline {
    std::size_t values = 0; ///< an upper bound
    std::size_t tooDeepAt = std::string_view::npos;
};

/// Counts values and depth without parsing: brackets and commas outside texts.
Outline outlineOf(std::string_view text) {
    Outline outline{1, std::string_view::npos};
    int depth = 0;
    bool isInText = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (isInText) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                isInText = false;
            continue;
        }
        if (c == '"')
            isInText = true;
        else if (c == ',' || c == ':')
            ++outline.values;
        else if (c == '[' || c == '{') {
            ++outline.values;
            if (++depth > limits::kNesting) {
                outline.tooDeepAt = i;
                return outline;
            }
        } else if (c == ']' || c == '}')
            --depth;
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
    bool number_integer(std::int64_t value) { return add(JsonKind::number, static_cast<double>(value)); }
    bool number_unsigned(std::uint64_t value) { return add(JsonKind::number, static_cast<double>(value)); }
    bool number_float(double parsed, const std::string& token) {
        // The library's own value depends on the locale, and under a comma locale its token carries a comma.
        std::string digits = token;
        std::replace(digits.begin(), digits.end(), ',', '.');
        double value = parsed;
        const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        // Out of range is an underflow here (overflow is an error of the library): the library's value stands.
        return add(JsonKind::number, result.ec == std::errc() ? value : parsed);
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
    bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception&) {
        errorByte_ = byte;
        return false;
    }

    [[nodiscard]] std::size_t errorByte() const { return errorByte_; }

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
};

} // namespace

std::variant<JsonTape, FileError> parseJson(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF"; // the library would take it in silence
    if (text.starts_with(kByteOrderMark))
        return errorAtByte(FileProblem::notJson, text, 0);
    const Outline outline = outlineOf(text);
    if (outline.tooDeepAt != std::string_view::npos) {
        FileError error = errorAtByte(FileProblem::nestedTooDeep, text, outline.tooDeepAt);
        error.numbers = {limits::kNesting};
        return error;
    }
    JsonTape tape;
    tape.entries.reserve(outline.values);
    TapeBuilder builder(tape);
    if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder))
        return errorAtByte(FileProblem::notJson, text, std::max<std::size_t>(builder.errorByte(), 1) - 1);
    return tape;
}

} // namespace kriva
