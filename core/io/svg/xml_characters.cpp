#include "core/io/svg/xml_characters.h"

#include "core/document/text/utf8.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace kriva {
namespace {

bool isAscii(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}

/// False where it is no character of Unicode, or NUL, which the parser would take for the end of the text.
bool isCharacter(std::uint32_t codePoint) {
    return codePoint != 0 && codePoint <= 0x10ffff && !(codePoint >= 0xd800 && codePoint < 0xe000);
}

std::string_view digitsOf(std::string_view reference) {
    const std::string_view digits = reference.substr(2, reference.size() - 3);
    return digits.starts_with('x') ? digits.substr(1) : digits;
}

/// How many bytes at the beginning of a text that is not empty are no character; 0 where there is one.
std::size_t brokenSize(std::string_view text) {
    if (!isAscii(text.front())) {
        const Utf8Character character = firstCharacter(text);
        return character.codePoint ? 0 : character.bytes.size();
    }
    const std::size_t size = text.front() == '&' ? characterReferenceSize(text) : 0;
    if (size == 0)
        return 0;
    const std::string_view digits = digitsOf(text.substr(0, size));
    std::uint32_t codePoint = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), codePoint, text[2] == 'x' ? 16 : 10);
    return error == std::errc() && isCharacter(codePoint) ? 0 : size;
}

/// Calls visit(std::string_view piece, bool isBroken) for each character, and for each piece that is none.
template <class Visit>
void forEachXmlPiece(std::string_view xml, Visit visit) {
    while (!xml.empty()) {
        const std::size_t broken = brokenSize(xml);
        const std::size_t size = broken > 0 ? broken : firstCharacter(xml).bytes.size();
        visit(xml.substr(0, size), broken > 0);
        xml.remove_prefix(size);
    }
}

} // namespace

std::size_t characterReferenceSize(std::string_view text) {
    if (!text.starts_with("&#"))
        return 0;
    const bool isHexadecimal = text.substr(2).starts_with('x');
    const std::size_t first = isHexadecimal ? 3 : 2;
    const std::size_t end = text.find_first_not_of(isHexadecimal ? "0123456789abcdefABCDEF" : "0123456789", first);
    return end != std::string_view::npos && end > first && text[end] == ';' ? end + 1 : 0;
}

bool saysThatItIsUtf8(std::string_view xml) {
    if (!xml.starts_with("<?xml"))
        return false;
    std::string declaration(xml.substr(0, xml.find("?>")));
    std::erase_if(declaration, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
    std::ranges::transform(declaration, declaration.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 0x20) : c; });
    return declaration.find("encoding=\"utf-8\"") != std::string::npos ||
           declaration.find("encoding='utf-8'") != std::string::npos;
}

std::size_t firstBrokenByte(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        if (isAscii(text[at])) {
            ++at;
            continue;
        }
        const Utf8Character character = firstCharacter(text.substr(at));
        if (!character.codePoint)
            return at;
        at += character.bytes.size();
    }
    return std::string_view::npos;
}

bool hasBrokenCharacters(std::string_view xml) {
    bool isBroken = false;
    forEachXmlPiece(xml, [&](std::string_view, bool isBrokenHere) { isBroken = isBroken || isBrokenHere; });
    return isBroken;
}

std::string withoutBrokenCharacters(std::string_view xml) {
    std::string repaired;
    repaired.reserve(xml.size());
    forEachXmlPiece(
        xml, [&](std::string_view piece, bool isBroken) { repaired += isBroken ? kReplacementCharacter : piece; });
    return repaired;
}

std::size_t byteBeforeRepair(std::string_view xml, std::size_t byte) {
    std::size_t before = 0;
    std::size_t after = 0;
    forEachXmlPiece(xml, [&](std::string_view piece, bool isBroken) {
        if (after >= byte)
            return;
        before += piece.size();
        after += isBroken ? kReplacementCharacter.size() : piece.size();
    });
    return before;
}

} // namespace kriva
