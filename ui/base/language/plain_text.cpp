#include "ui/base/language/plain_text.h"

#include "core/curve/text/utf8.h"

namespace kriva::ui {
QString printable(const QString& text) {
    QString result;
    result.reserve(text.size());
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text[i];
        if (c.isHighSurrogate() && i + 1 < text.size() && text[i + 1].isLowSurrogate()) {
            result += c;
            result += text[++i];
        } else if (c.isSurrogate() || isUnprintable(c.unicode())) {
            result += QStringLiteral("\\u%1").arg(c.unicode(), 4, 16, QLatin1Char('0'));
        } else {
            result += c;
        }
    }
    return result;
}

QString wellFormed(QString text) {
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (!text[i].isSurrogate())
            continue;
        const bool isWhole = text[i].isHighSurrogate() && i + 1 < text.size() && text[i + 1].isLowSurrogate();
        if (isWhole)
            ++i;
        else
            text[i] = QChar::ReplacementCharacter;
    }
    return text;
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
