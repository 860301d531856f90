#include "ui/shell/long_work.h"

#include <QEventLoop>
#include <QPointer>
#include <QProgressDialog>
#include <QTimer>

#include <thread>

namespace kriva::ui {
namespace {

/// In milliseconds: what is done by then needs no dialog.
constexpr int kPatience = 500;

} // namespace

bool finishes(const std::function<void(WorkBudget&)>& work, const QString& title, QWidget* window) {
    std::stop_source stop;
    bool hasEnded = false;
    QEventLoop waiting;
    const std::jthread thread([&] {
        WorkBudget budget(WorkBudget::kUnlimited, stop.get_token());
        work(budget);
        QMetaObject::invokeMethod(&waiting, [&] {
            hasEnded = true;
            waiting.quit();
        });
    });

    QTimer::singleShot(kPatience, &waiting, &QEventLoop::quit);
    waiting.exec(QEventLoop::ExcludeUserInputEvents); // nothing may change meanwhile
    if (!hasEnded) {
        const QPointer dialog = new QProgressDialog(window);
        dialog->setLabelText(title);
        dialog->setRange(0, 0); // nobody knows how long
        dialog->setWindowModality(Qt::ApplicationModal);
        dialog->setMinimumDuration(0);
        QObject::connect(dialog, &QProgressDialog::canceled, &waiting, [&stop] { stop.request_stop(); });
        dialog->show();
        waiting.exec(); // also ended by the end of the program
        delete dialog;
    }
    const bool isDone = hasEnded && !stop.stop_requested();
    stop.request_stop();
    return isDone;
}

} // namespace kriva::ui
