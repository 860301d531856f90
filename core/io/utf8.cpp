#include "core/io/utf8.h"

namespace kriva {

Utf8Character firstCharacter(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return {lead, text.substr(0, 1)};
    const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    const Utf8Character broken{std::nullopt, text.substr(0, 1)};
    if (lead < 0xc2 || lead > 0xf4 || text.size() < size)
        return broken;
    char32_t codePoint = lead & (0xffu >> (size + 1));
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0) != 0x80)
            return broken;
        codePoint = codePoint << 6 | (byte(i) & 0x3fu);
    }
    constexpr char32_t kSmallest[] = {0x80, 0x800, 0x10000}; // of 2, 3 and 4 bytes
    const bool isSurrogate = codePoint >= 0xd800 && codePoint < 0xe000;
    if (codePoint < kSmallest[size - 2] || codePoint > 0x10ffff || isSurrogate)
        return broken;
    return {codePoint, text.substr(0, size)};
}

} // namespace kriva
