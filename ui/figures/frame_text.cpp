#include "ui/figures/frame_text.h"

#include "ui/base/language/number_text.h"

#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace kriva::ui {
namespace {

QStringList partsOf(const QString& text) {
    static const QRegularExpression blanks(QStringLiteral("[\\s;]+"));
    static const QRegularExpression commas(QStringLiteral("\\s*,\\s*"));
    // "0, 5, 10" has commas and blanks; a decimal comma has no blank behind it.
    static const QRegularExpression commaAndBlank(QStringLiteral(",\\s"));
    const bool hasBlanks = text.contains(blanks);
    const bool partsByCommas = !hasBlanks || text.contains(commaAndBlank);
    return text.split(partsByCommas ? commas : blanks, Qt::SkipEmptyParts);
}

std::optional<double> stageOf(const QString& text) {
    const std::optional<double> number = parseNumber(text);
    const bool isStage = number && *number >= 0 && *number <= kMostStage && *number == std::floor(*number);
    return isStage ? number : std::nullopt;
}

/// "5" or "0..10"
bool addStages(const QString& part, std::vector<FramePlace>& places) {
    const QStringList ends = part.split(QStringLiteral(".."));
    const std::optional<double> first = stageOf(ends.constFirst());
    const std::optional<double> last = stageOf(ends.constLast());
    if (ends.size() > 2 || !first || !last || *last < *first || *last - *first >= kMostFrames)
        return false;
    for (double at = *first; at <= *last; ++at)
        places.push_back({FramePlace::Over::stage, at});
    return true;
}

} // namespace

std::optional<std::vector<FramePlace>> readFramePlaces(const QString& text) {
    static const QRegularExpression ofT(QStringLiteral("^t\\s*=\\s*"));
    QString rest = text.trimmed();
    const bool isOverT = rest.contains(ofT);
    rest.remove(ofT);
    std::vector<FramePlace> places;
    for (const QString& part : partsOf(rest)) {
        const std::optional<double> t = isOverT ? parseNumber(part) : std::nullopt;
        if (isOverT ? !t : !addStages(part, places))
            return {};
        if (isOverT)
            places.push_back({FramePlace::Over::t, *t});
    }
    if (places.size() > kMostFrames || (isOverT && places.empty()))
        return {};
    return places;
}

QString framePlacesText(const std::vector<FramePlace>& places) {
    QStringList numbers;
    for (const FramePlace& place : places)
        numbers.append(formatNumber(place.at));
    const bool isOverT = !places.empty() && places.front().over == FramePlace::Over::t;
    return (isOverT ? QStringLiteral("t = ") : QString()) + numbers.join(QStringLiteral("; "));
}

} // namespace kriva::ui
