#include "ui/panels/result_text.h"

#include "ui/figures/caption_text.h"

#include <QLocale>
#include <QStringList>

#include <cmath>

namespace kriva::ui {
namespace {

/// Makes texts of the values that a result can have.
struct ValueText {
    int digits;

    [[nodiscard]] QString operator()(double number) const {
        if (!std::isfinite(number))
            return QStringLiteral("–");
        QLocale locale;
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        return locale.toString(number, 'g', digits);
    }
    [[nodiscard]] QString operator()(int number) const { return QString::number(number); }
    [[nodiscard]] QString operator()(const std::string& text) const { return QString::fromStdString(text); }
    [[nodiscard]] QString operator()(Caption caption) const { return captionText(caption); }
    // A semicolon keeps numbers apart in languages that write a decimal comma.
    [[nodiscard]] QString operator()(Point p) const { return list(std::vector{p.x, p.y}); }
    [[nodiscard]] QString operator()(const Box& box) const {
        return QStringLiteral("%1 – %2").arg((*this)(Point{box.xmin, box.ymin}), (*this)(Point{box.xmax, box.ymax}));
    }
    [[nodiscard]] QString operator()(const Points& points) const {
        QStringList texts;
        for (const Point p : points)
            texts.append((*this)(p));
        return texts.join(QLatin1Char(' '));
    }
    [[nodiscard]] QString operator()(const std::vector<double>& numbers) const { return list(numbers); }

  private:
    [[nodiscard]] QString list(const std::vector<double>& numbers) const {
        QStringList texts;
        for (const double number : numbers)
            texts.append((*this)(number));
        return QStringLiteral("(%1)").arg(texts.join(QLatin1String("; ")));
    }
};

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

} // namespace kriva::ui
