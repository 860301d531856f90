#include "ui/clipboard/clip.h"

#include "core/document/conversion.h"
#include "core/io/svg/curve_svg.h"
#include "core/io/svg/imported.h"
#include "core/io/tables/points_writer.h"
#include "ui/base/language/plain_text.h"
#include "ui/document/error_text.h"
#include "ui/document/import_text.h"
#include "ui/figures/caption_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace kriva::ui {
namespace {

const QString kSvgFormat = QStringLiteral("image/svg+xml");

[[nodiscard]] QByteArray bytesOf(std::string_view text) {
    return {text.data(), static_cast<qsizetype>(text.size())};
}

[[nodiscard]] std::string_view charactersOf(const QByteArray& bytes) {
    return {bytes.constData(), static_cast<std::size_t>(bytes.size())};
}

using Clipped = std::variant<Fragment, std::vector<Curve>, QString>;

class ClipTexts {
    Q_DECLARE_TR_FUNCTIONS(Clip)
  public:
    static QString refusal(const QString& why) { return tr("The clipboard: %1").arg(why); }
    static QString ownRefusal(const QString& why) { return tr("The clipboard: its curve cannot be read: %1").arg(why); }
};

[[nodiscard]] Clipped readOwn(const QByteArray& text, SheetIndex sheet) {
    const auto read = readFragment(charactersOf(text));
    if (const FileError* error = std::get_if<FileError>(&read))
        return ClipTexts::ownRefusal(reasonText(*error));
    Fragment fragment = std::get<Fragment>(read);
    fragment.curve = converted(fragment.curve, sheet);
    return fragment;
}

/// Points go behind those of a curve that is there; paths are curves of their own.
[[nodiscard]] Clipped readForeign(const QByteArray& text, SheetIndex sheet) {
    const auto read = readImport(text);
    if (const QString* refusal = std::get_if<QString>(&read))
        return ClipTexts::refusal(*refusal);
    const auto& paths = std::get<std::vector<ImportedPath>>(read);
    if (!holdsPaths(charactersOf(text))) {
        Curve points = emptyCurve(sheet);
        for (const ImportedPath& imported : paths)
            points = withPathAdded(std::move(points), imported.path);
        return Fragment{Fragment::Content::points, std::move(points)};
    }
    auto curves = importedCurves(paths, sheet);
    if (const FileError* error = std::get_if<FileError>(&curves))
        return ClipTexts::refusal(errorText(*error));
    return std::get<std::vector<Curve>>(std::move(curves));
}

} // namespace

std::unique_ptr<QMimeData> clipOf(const Fragment& fragment, std::optional<double> mmPerUnit) {
    auto clip = std::make_unique<QMimeData>();
    clip->setData(QString::fromLatin1(kFragmentFormat), bytesOf(writeFragment(fragment)));
    if (const std::optional<std::string> svg = writeCurveSvg(fragment.curve, mmPerUnit, textSource()))
        clip->setData(kSvgFormat, bytesOf(*svg));
    clip->setText(
        QString::fromStdString(writePointsTable(pointsOf(fragment.curve), QLocale().decimalPoint().toStdString())));
    return clip;
}

Clipped readClip(const QMimeData& clip, SheetIndex sheet) {
    const QString own = QString::fromLatin1(kFragmentFormat);
    if (clip.hasFormat(own))
        return readOwn(clip.data(own), sheet);
    const bool isFigure = !clip.hasText() && clip.hasFormat(kSvgFormat);
    return readForeign(isFigure ? clip.data(kSvgFormat) : wellFormed(clip.text()).toUtf8(), sheet);
}

} // namespace kriva::ui
