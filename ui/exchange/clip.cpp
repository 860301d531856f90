#include "ui/exchange/clip.h"

#include "core/exchange/conversion.h"
#include "core/exchange/curve_svg.h"
#include "ui/document/error_text.h"
#include "ui/exchange/points_table.h"
#include "ui/figures/caption_text.h"

#include <QCoreApplication>

namespace kriva::ui {
namespace {

[[nodiscard]] QByteArray bytesOf(std::string_view text) {
    return {text.data(), static_cast<qsizetype>(text.size())};
}

[[nodiscard]] std::variant<Fragment, QString> readOwn(const QByteArray& text, SheetIndex sheet) {
    const auto read = readFragment({text.constData(), static_cast<std::size_t>(text.size())});
    if (const FileError* error = std::get_if<FileError>(&read))
        return QCoreApplication::translate("Clip", "The clipboard: %1").arg(errorText(*error));
    Fragment fragment = std::get<Fragment>(read);
    fragment.curve = converted(fragment.curve, sheet);
    return fragment;
}

[[nodiscard]] std::variant<Fragment, QString> readTable(const QString& text, SheetIndex sheet) {
    const auto read = readPointsTable(text);
    if (const TableError* error = std::get_if<TableError>(&read))
        return errorText(*error);
    return Fragment{Fragment::Content::points, withPointsAdded(emptyCurve(sheet), std::get<Points>(read))};
}

} // namespace

std::unique_ptr<QMimeData> clipOf(const Fragment& fragment, std::optional<double> mmPerUnit) {
    auto clip = std::make_unique<QMimeData>();
    clip->setData(QString::fromLatin1(kFragmentFormat), bytesOf(writeFragment(fragment)));
    if (const std::optional<std::string> svg = writeCurveSvg(fragment.curve, mmPerUnit, textSource()))
        clip->setData(QStringLiteral("image/svg+xml"), bytesOf(*svg));
    clip->setText(pointsTable(pointsOf(fragment.curve)));
    return clip;
}

std::variant<Fragment, QString> readClip(const QMimeData& clip, SheetIndex sheet) {
    const QString own = QString::fromLatin1(kFragmentFormat);
    return clip.hasFormat(own) ? readOwn(clip.data(own), sheet) : readTable(clip.text(), sheet);
}

} // namespace kriva::ui
