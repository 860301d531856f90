#include "core/io/svg/xml/xml_text.h"

#include "core/curve/text/utf8.h"

namespace kriva {
namespace {

/// Control characters of both blocks, and what XML 1.0 (section 2.2) leaves out.
bool isForbidden(char32_t c) {
    return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0xfffe || c == 0xffff;
}

void appendEscaped(std::string& to, std::string_view bytes) {
    switch (bytes[0]) {
    case '<':
        to += "&lt;";
        break;
    case '>':
        to += "&gt;";
        break;
    case '&':
        to += "&amp;";
        break;
    case '"':
        to += "&quot;";
        break;
    case '\'':
        to += "&apos;";
        break;
    default:
        to += bytes;
    }
}

void appendJsonEscape(std::string& to, char32_t c) {
    constexpr char kHex[] = "0123456789abcdef";
    to += "\\u";
    for (const int shift : {12, 8, 4, 0})
        to += kHex[c >> shift & 15];
}

} // namespace

std::string xmlText(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    forEachCharacter(text, [&](std::optional<char32_t> c, std::string_view bytes) {
        if (!c || isForbidden(*c))
            result += kReplacementCharacter;
        else
            appendEscaped(result, bytes);
    });
    return result;
}

std::string xmlJson(std::string_view json) {
    std::string result;
    result.reserve(json.size());
    forEachCharacter(json, [&](std::optional<char32_t> c, std::string_view bytes) {
        // Between values JSON has line breaks; inside its texts they are escaped already.
        if (c && *c != '\n' && isForbidden(*c))
            appendJsonEscape(result, *c);
        else if (bytes[0] == '"' || bytes[0] == '\'')
            result += bytes; // quotes need no escape in an element
        else
            appendEscaped(result, bytes);
    });
    return result;
}

} // namespace kriva
