#include "ui/panels/guide/formula_html.h"

#include <QRegularExpression>
#include <QStringList>

namespace kriva::ui {

using namespace Qt::StringLiterals;

namespace {

[[nodiscard]] bool isLatin(QChar c) {
    return c.isLetter() && c.unicode() < 0x80;
}

/// Signs that stand one above the other: rows of classes KIND-0, KIND-1 and so on, without those that are empty.
[[nodiscard]] QString pile(const QStringList& rows, QLatin1StringView kind) {
    QString table = u"<table cellspacing=\"0\" cellpadding=\"0\">"_s;
    for (qsizetype i = 0; i < rows.size(); ++i)
        if (!rows[i].isEmpty())
            table += u"<tr><td align=\"center\" class=\"%1-%2\">%3</td></tr>"_s.arg(kind).arg(i).arg(rows[i]);
    return table + u"</table>"_s;
}

/// Reads a formula once from left to right. With piles it becomes cells of a row, which is the only way to put one
/// thing above another; else it is text, which can go on in the next line.
class Reader {
  public:
    Reader(QStringView formula, bool hasPiles)
        : rest_(formula)
        , hasPiles_(hasPiles) {}

    [[nodiscard]] QString html() {
        QString text;
        while (!rest_.isEmpty())
            text += next();
        return text;
    }

  private:
    QChar take() {
        const QChar first = rest_.front();
        rest_ = rest_.sliced(1);
        return first;
    }
    /// What stands up to the sign, which is left out.
    QStringView takeUntil(QChar end) {
        const qsizetype at = rest_.indexOf(end);
        const QStringView found = at < 0 ? rest_ : rest_.first(at);
        rest_ = at < 0 ? QStringView() : rest_.sliced(at + 1);
        return found;
    }
    [[nodiscard]] static QString inner(QStringView formula) { return Reader(formula, false).html(); }

    QString next() {
        const QChar c = take();
        if (c == u'_' || c == u'^')
            return shifted(c == u'_' ? u"sub"_s : u"sup"_s);
        if (c == u'\\')
            return command();
        if (c == u'&') // an entity of HTML
            return u"&%1;"_s.arg(takeUntil(u';'));
        if (c == u'-')
            return u"−"_s;
        if (c == u'\'')
            return u"′"_s;
        if (c == u'/')
            return u"/\u2060"_s; // no line ends behind it
        if (c == u'~')
            return u"&nbsp;&nbsp;&nbsp;"_s; // Qt takes wider blanks for one of many
        if (c == u' ' && hasPiles_)         // at the ends of cells it would be lost
            return u"&nbsp;"_s;
        return isLatin(c) ? u"<i>%1</i>"_s.arg(c) : QString(c);
    }
    QString shifted(const QString& tag) {
        if (rest_.isEmpty())
            return {};
        const bool isGroup = rest_.front() == u'{';
        if (isGroup)
            rest_ = rest_.sliced(1);
        const QStringView content = isGroup ? takeUntil(u'}') : rest_.first(1);
        if (!isGroup)
            rest_ = rest_.sliced(1);
        return u"<%1>%2</%1>"_s.arg(tag, inner(content));
    }
    QString command() {
        QString name;
        while (!rest_.isEmpty() && isLatin(rest_.front()))
            name += take();
        if (rest_.isEmpty() || rest_.front() != u'{')
            return name;
        rest_ = rest_.sliced(1);
        const QStringView arguments = takeUntil(u'}');
        const qsizetype bar = arguments.indexOf(u'|');
        const QString a = inner(arguments.first(std::max<qsizetype>(bar, 0)));
        const QString b = inner(arguments.sliced(bar + 1));
        if (hasPiles_)
            return u"</td><td>%1</td><td>"_s.arg(piled(name, a, b));
        if (name == u"sum" || name == u"int")
            return name == u"sum" ? u"Σ"_s : u"∫"_s;
        return name == u"binom" ? u"(%1 | %2)"_s.arg(a, b) : u"%1/%2"_s.arg(a, b);
    }
    [[nodiscard]] static QString piled(const QString& name, const QString& a, const QString& b) {
        if (name == u"sum" || name == u"int")
            return pile({b, name == u"sum" ? u"Σ"_s : u"∫"_s, a}, QLatin1StringView("sum"));
        if (name == u"binom")
            return u"<table cellspacing=\"0\" cellpadding=\"0\"><tr><td class=\"brace\">(</td><td>%1</td>"
                   "<td class=\"brace\">)</td></tr></table>"_s.arg(pile({a, b}, QLatin1StringView("binom")));
        return pile({a, b}, QLatin1StringView("frac"));
    }

    QStringView rest_;
    bool hasPiles_;
};

/// A formula on a line of its own.
[[nodiscard]] QString display(QStringView formula) {
    static const QRegularExpression pile(u"\\\\[a-z]+\\{"_s);
    if (!pile.match(formula).hasMatch())
        return u"<p class=\"formula\" align=\"center\">%1</p>"_s.arg(Reader(formula, false).html());
    return u"<table class=\"formula\" align=\"center\" cellspacing=\"0\" cellpadding=\"0\"><tr><td>%1</td></tr></table>"_s
        .arg(Reader(formula, true).html());
}

} // namespace

QString withFormulas(const QString& page) {
    static const QRegularExpression formula(u"\\$\\$([^$]+)\\$\\$|\\$([^$]+)\\$"_s);
    QString html;
    qsizetype from = 0;
    for (auto matches = formula.globalMatch(page); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        html += QStringView(page).sliced(from, match.capturedStart() - from);
        html += match.hasCaptured(2)
                    ? u"<span class=\"math\">%1</span>"_s.arg(Reader(match.capturedView(2), false).html())
                    : display(match.capturedView(1).trimmed());
        from = match.capturedEnd();
    }
    html += QStringView(page).sliced(from);
    static const QRegularExpression pair(u"\\(([^\\s(),<]{1,5}), ([^\\s(),<]{1,5})\\)"_s);
    return html.replace(pair, u"(\\1,&nbsp;\\2)"_s); // the coordinates of a point stay on one line
}

} // namespace kriva::ui
