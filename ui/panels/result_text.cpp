#include "ui/panels/result_text.h"

#include "ui/base/language/number_text.h"
#include "ui/figures/caption_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace kriva::ui {
namespace {

class Values {
    Q_DECLARE_TR_FUNCTIONS(Values)
  public:
    static QString moreThan(int count) { return tr("more than %L1").arg(count); }
};

/// Makes texts of the values that a result can have.
struct ValueText {
    int digits;

    [[nodiscard]] QString operator()(double number) const {
        return std::isfinite(number) ? shownNumber(number, digits) : QStringLiteral("–");
    }
    [[nodiscard]] QString operator()(int number) const { return QString::number(number); }
    [[nodiscard]] QString operator()(const std::string& text) const { return QString::fromStdString(text); }
    [[nodiscard]] QString operator()(Caption caption) const { return captionText(caption); }
    // A semicolon keeps numbers apart in languages that write a decimal comma.
    [[nodiscard]] QString operator()(Point p) const { return list(std::vector{p.x, p.y}); }
    [[nodiscard]] QString operator()(Vector v) const { return list(std::vector{v.x, v.y}); }
    [[nodiscard]] QString operator()(const Box& box) const {
        return QStringLiteral("%1 – %2").arg((*this)(Point{box.xmin, box.ymin}), (*this)(Point{box.xmax, box.ymax}));
    }
    template <class Pair>
    [[nodiscard]] QString operator()(const std::vector<Pair>& pairs) const {
        QStringList texts;
        for (const Pair pair : pairs)
            texts.append((*this)(pair));
        return texts.join(QLatin1Char(' '));
    }
    [[nodiscard]] QString operator()(const std::vector<double>& numbers) const { return list(numbers); }
    /// "c₀(0.25) = c₃(0.5) = (2; 1)", with the curve in front where there are several: "1: c₀(0.25)".
    [[nodiscard]] QString operator()(const PassedPlace& place) const {
        constexpr int kDigitsOfT = 4;
        QString text;
        for (const PassedPlace::Pass& pass : place.passes) {
            if (pass.curve)
                text += QStringLiteral("%1: ").arg(*pass.curve);
            text += QStringLiteral("%1(%2) = ")
                        .arg(indexed(QStringLiteral("c"), QString::number(pass.segment)),
                             ValueText{std::min(digits, kDigitsOfT)}(pass.t));
        }
        return text + (*this)(place.at);
    }

    [[nodiscard]] QString operator()(const MoreThan& most) const { return Values::moreThan(most.count); }

  private:
    [[nodiscard]] QString list(const std::vector<double>& numbers) const {
        QStringList texts;
        for (const double number : numbers)
            texts.append((*this)(number));
        return QStringLiteral("(%1)").arg(texts.join(QLatin1String("; ")));
    }
};

/// Each character and the same one as an index.
constexpr std::array<std::pair<char16_t, char16_t>, 15> kIndices{{
    {u'0', u'₀'},
    {u'1', u'₁'},
    {u'2', u'₂'},
    {u'3', u'₃'},
    {u'4', u'₄'},
    {u'5', u'₅'},
    {u'6', u'₆'},
    {u'7', u'₇'},
    {u'8', u'₈'},
    {u'9', u'₉'},
    {u'+', u'₊'},
    {u'−', u'₋'},
    {u'i', u'ᵢ'},
    {u'j', u'ⱼ'},
    {u'n', u'ₙ'},
}};

} // namespace

QString resultName(const Result& result) {
    const QString caption = captionText(result.caption);
    return result.index.empty() ? caption : caption + QLatin1Char(' ') + QString::fromStdString(result.index);
}

QString resultValue(const Result& result, int digits) {
    return result.value ? valueText(*result.value, digits) : QStringLiteral("–");
}

QString valueText(const Result::Value& value, int digits) {
    return std::visit(ValueText{digits}, value);
}

QString indexed(const QString& letter, const QString& index) {
    QString text = letter;
    for (const QChar character : index) {
        const auto* known = std::ranges::find(kIndices, character.unicode(), &std::pair<char16_t, char16_t>::first);
        if (known == kIndices.end())
            return letter + QLatin1Char('_') + index;
        text += QChar(known->second);
    }
    return text;
}

} // namespace kriva::ui
