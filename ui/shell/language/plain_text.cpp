#include "ui/shell/language/plain_text.h"

#include <algorithm>
#include <array>

namespace kriva::ui {
namespace {

bool isBidirectional(char16_t c) {
    constexpr std::array<char16_t, 3> kMarks{0x061c, 0x200e, 0x200f};
    return std::find(kMarks.begin(), kMarks.end(), c) != kMarks.end() || (c >= 0x202a && c <= 0x202e) ||
           (c >= 0x2066 && c <= 0x2069);
}

bool isPrintable(QChar c) {
    const bool breaksLines = c.category() == QChar::Separator_Line || c.category() == QChar::Separator_Paragraph;
    return c.category() != QChar::Other_Control && !breaksLines && !isBidirectional(c.unicode()) && !c.isSurrogate();
}

} // namespace

QString printable(const QString& text) {
    QString result;
    result.reserve(text.size());
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text[i];
        if (c.isHighSurrogate() && i + 1 < text.size() && text[i + 1].isLowSurrogate()) {
            result += c;
            result += text[++i];
        } else if (isPrintable(c)) {
            result += c;
        } else {
            result += QStringLiteral("\\u%1").arg(c.unicode(), 4, 16, QLatin1Char('0'));
        }
    }
    return result;
}

QString toolTipOf(const QString& text) {
    // The tag has Qt take it for HTML in any case: otherwise an entity would be shown as it is written.
    return text.isEmpty() ? QString() : QStringLiteral("<span>%1</span>").arg(printable(text).toHtmlEscaped());
}

QString windowTitleOf(const QString& text) {
    return printable(text).replace(QLatin1String("[*]"), QLatin1String("[*][*]"));
}

QString actionTextOf(const QString& text) {
    return printable(text).replace(QLatin1Char('&'), QLatin1String("&&"));
}

} // namespace kriva::ui
