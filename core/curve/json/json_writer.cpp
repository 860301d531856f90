#include "core/curve/json/json_writer.h"

#include "core/curve/text/utf8.h"

#include <charconv>
#include <cmath>

namespace kriva {
namespace {

void appendEscape(std::string& to, char32_t c) {
    constexpr char kHex[] = "0123456789abcdef";
    to += "\\u";
    for (const int shift : {12, 8, 4, 0})
        to += kHex[c >> shift & 15];
}

} // namespace

JsonWriter& JsonWriter::open(char bracket) {
    separate();
    text_ += bracket;
    ++depth_;
    isFirst_ = true;
    return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
    --depth_;
    if (!isFirst_ && depth_ < linesDownTo_)
        breakLine();
    text_ += bracket;
    isFirst_ = false;
    return *this;
}

void JsonWriter::separate() {
    if (isAfterKey_) {
        isAfterKey_ = false;
        return;
    }
    if (depth_ == 0)
        return;
    if (!isFirst_)
        text_ += ',';
    if (depth_ <= linesDownTo_)
        breakLine();
    else if (!isFirst_)
        text_ += ' ';
    isFirst_ = false;
}

void JsonWriter::breakLine() {
    text_ += '\n';
    text_.append(static_cast<std::size_t>(depth_) * 2, ' ');
}

JsonWriter& JsonWriter::raw(std::string_view text) {
    separate();
    text_ += text;
    return *this;
}

JsonWriter& JsonWriter::key(std::string_view name) {
    value(name);
    text_ += ": ";
    isAfterKey_ = true;
    return *this;
}

JsonWriter& JsonWriter::value(double number) {
    if (!std::isfinite(number))
        return raw("null");
    if (number == 0 && std::signbit(number))
        return raw("-0.0"); // "-0" would read back as the integer 0
    char digits[32];
    char* const end = digits + sizeof digits;
    const auto result = digits_ == Digits::shortest
                            ? std::to_chars(digits, end, number)
                            : std::to_chars(digits, end, number, std::chars_format::general, 17);
    return raw({digits, static_cast<std::size_t>(result.ptr - digits)});
}

JsonWriter& JsonWriter::value(int number) {
    char digits[16];
    const auto result = std::to_chars(digits, digits + sizeof digits, number);
    return raw({digits, static_cast<std::size_t>(result.ptr - digits)});
}

JsonWriter& JsonWriter::value(bool isTrue) {
    return raw(isTrue ? "true" : "false");
}

JsonWriter& JsonWriter::value(std::string_view text) {
    separate();
    text_ += '"';
    forEachCharacter(text, [&](std::optional<char32_t> c, std::string_view bytes) {
        if (!c || *c == 0)
            text_ += kReplacementCharacter;
        else if (*c == '"' || *c == '\\')
            text_.append("\\").append(bytes);
        else if (isUnprintable(*c))
            appendEscape(text_, *c);
        else
            text_ += bytes;
    });
    text_ += '"';
    return *this;
}

JsonWriter& JsonWriter::value(Point point) {
    return beginList().value(point.x).value(point.y).endList();
}

JsonWriter& JsonWriter::value(const Box& box) {
    return beginList().value(box.xmin).value(box.ymin).value(box.xmax).value(box.ymax).endList();
}

JsonWriter& JsonWriter::value(std::span<const Point> points) {
    beginList();
    for (const Point p : points)
        value(p);
    return endList();
}

JsonWriter& JsonWriter::value(std::span<const double> numbers) {
    beginList();
    for (const double number : numbers)
        value(number);
    return endList();
}

std::string JsonWriter::take() && {
    text_ += '\n';
    return std::move(text_);
}

} // namespace kriva
