#include "ui/figures/caption_text.h"

#include "ui/base/language/number_text.h"

#include <QCoreApplication>

namespace kriva::ui {

QString captionText(Caption caption) {
    return caption == Caption::none ? QString() : QCoreApplication::translate("Caption", caption.words());
}

TextSource textSource() {
    return {[](Caption caption) { return captionText(caption).toStdString(); },
            [](double value, int decimals) { return withMinus(formatNumber(value, decimals)).toStdString(); },
            QLocale().bcp47Name().toStdString()};
}

} // namespace kriva::ui
