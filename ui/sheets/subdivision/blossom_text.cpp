#include "ui/sheets/subdivision/blossom_text.h"

#include "core/document/limits.h"
#include "ui/shell/language/number_text.h"

#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace kriva::ui {

QString blossomText(const std::vector<double>& arguments) {
    QStringList texts;
    for (const double argument : arguments)
        texts.append(formatNumber(argument));
    return texts.join(QLatin1String("; "));
}

std::optional<std::vector<double>> blossomArguments(const QString& text) {
    static const QRegularExpression separator(QStringLiteral("\\s*;\\s*|\\s+"));
    std::vector<double> arguments;
    for (const QString& part : text.trimmed().split(separator)) {
        const std::optional<double> number = parseNumber(part);
        if (!number || std::abs(*number) > limits::kNumber)
            return {};
        arguments.push_back(*number);
    }
    return arguments;
}

} // namespace kriva::ui
