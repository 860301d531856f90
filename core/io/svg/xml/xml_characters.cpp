#include "core/io/svg/xml/xml_characters.h"

#include "core/curve/text/utf8.h"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace kriva {
namespace {

bool isAscii(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}

bool isXmlCharacter(char32_t codePoint) {
    const bool isBlank = codePoint == '\t' || codePoint == '\n' || codePoint == '\r';
    const bool isSurrogate = codePoint >= 0xd800 && codePoint < 0xe000;
    return (codePoint >= 0x20 || isBlank) && !isSurrogate && codePoint != 0xfffe && codePoint != 0xffff &&
           codePoint <= 0x10ffff;
}

std::string_view digitsOf(std::string_view reference) {
    const std::string_view digits = reference.substr(2, reference.size() - 3);
    return digits.starts_with('x') ? digits.substr(1) : digits;
}

/// Whether a reference is to a character that XML has (XML 1.0, section 2.2): "&#xD800;" and "&#1;" are not.
bool isToXmlCharacter(std::string_view reference) {
    const std::string_view digits = digitsOf(reference);
    std::uint32_t codePoint = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), codePoint, reference[2] == 'x' ? 16 : 10);
    return error == std::errc() && isXmlCharacter(codePoint);
}

/// How many bytes at the beginning of a text that is not empty are no character; 0 where there is one.
std::size_t brokenSize(std::string_view text) {
    if (!isAscii(text.front())) {
        const Utf8Character character = firstCharacter(text);
        return character.codePoint ? 0 : character.bytes.size();
    }
    const std::size_t size = text.front() == '&' ? characterReferenceSize(text) : 0;
    return size > 0 && !isToXmlCharacter(text.substr(0, size)) ? size : 0;
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

/// A control, U+FFFE or U+FFFF; empty where there is none. Of bytes that are not UTF-8 it finds controls alone.
std::string_view firstForbiddenCharacter(std::string_view text, bool isUtf8) {
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (isAscii(text[at]) && !isXmlCharacter(static_cast<unsigned char>(text[at])))
            return text.substr(at, 1);
        constexpr char kLeadOfBoth = '\xEF'; // of U+FFFE and U+FFFF
        if (!isUtf8 || text[at] != kLeadOfBoth)
            continue;
        const Utf8Character character = firstCharacter(text.substr(at));
        if (character.codePoint && !isXmlCharacter(*character.codePoint))
            return character.bytes;
    }
    return {};
}

/// In small letters; empty where the declaration names none.
std::string declaredEncoding(std::string_view xml) {
    if (!xml.starts_with("<?xml"))
        return {};
    std::string declaration(xml.substr(0, xml.find("?>")));
    std::erase_if(declaration, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
    std::ranges::transform(declaration, declaration.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 0x20) : c; });
    constexpr std::string_view kKey = "encoding=";
    const std::size_t key = declaration.find(kKey);
    if (key == std::string::npos || key + kKey.size() == declaration.size())
        return {};
    const std::size_t name = key + kKey.size() + 1;
    const std::size_t end = declaration.find(declaration[name - 1], name);
    return end == std::string::npos ? std::string() : declaration.substr(name, end - name);
}

/// Whether it has one byte for each character, and ASCII as it is: all but names can be read.
bool isNameOfBytes(std::string_view encoding) {
    constexpr std::string_view kFamilies[] = {"iso-8859-", "iso8859-", "iso_8859-", "latin", "windows-125", "cp125",
                                              "cp866",     "ibm866",   "koi8-",     "mac",   "x-mac-"};
    return std::ranges::any_of(kFamilies, [&](std::string_view family) { return encoding.starts_with(family); });
}

/// "U+FFFE" of the bytes of a character.
std::string codeOf(std::string_view bytes) {
    constexpr char kHex[] = "0123456789ABCDEF";
    const char32_t c = firstCharacter(bytes).codePoint.value_or(0);
    std::string code = "U+";
    for (const int shift : {12, 8, 4, 0})
        code += kHex[c >> shift & 15];
    return code;
}

FileError withWord(FileError error, const std::string& word) {
    constexpr std::size_t kTold = 100; // bytes: files have names as long as they like
    error.words = {word.substr(0, kTold)};
    return error;
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

std::optional<FileError> xmlCharacterError(std::string_view xml) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    const std::size_t start = xml.starts_with(kMark) ? kMark.size() : 0;
    const std::string encoding = declaredEncoding(xml.substr(start));
    const bool isUtf8 = encoding == "utf-8" || encoding == "utf8";
    if (const std::size_t broken = isUtf8 ? firstBrokenByte(xml) : std::string_view::npos;
        broken != std::string_view::npos)
        return errorAtByte(FileProblem::notInEncoding, xml, broken);
    const bool isRead = isUtf8 || encoding.empty() || isNameOfBytes(encoding);
    if (const auto* const first = std::ranges::find_if_not(xml.substr(start), isAscii);
        !isRead && first != xml.data() + xml.size())
        return withWord(errorAtByte(FileProblem::unknownEncoding, xml, static_cast<std::size_t>(first - xml.data())),
                        encoding);
    const std::string_view forbidden = firstForbiddenCharacter(xml, isUtf8 || encoding.empty());
    if (forbidden.empty())
        return {};
    return withWord(
        errorAtByte(FileProblem::noXmlCharacter, xml, static_cast<std::size_t>(forbidden.data() - xml.data())),
        codeOf(forbidden));
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
