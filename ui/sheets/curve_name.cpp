#include "ui/sheets/curve_name.h"

#include <QCoreApplication>

namespace kriva::ui {

QString curveName(const Curve& curve, int index) {
    const std::string& name = nameOf(curve);
    return name.empty() ? QCoreApplication::translate("CurveName", "Curve %1").arg(index + 1)
                        : QString::fromStdString(name);
}

} // namespace kriva::ui
