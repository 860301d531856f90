#include "ui/editing/sheet/curve_name.h"

#include "ui/base/language/plain_text.h"

#include <QCoreApplication>

namespace kriva::ui {

QString curveName(const Curve& curve, int index) {
    const std::string& name = nameOf(curve);
    return name.empty() ? QCoreApplication::translate("CurveName", "Curve %1").arg(index + 1)
                        : printable(QString::fromStdString(name));
}

} // namespace kriva::ui
