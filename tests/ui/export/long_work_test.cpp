#include "ui/export/long_work.h"

#include <gtest/gtest.h>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QTimer>

#include <thread>

namespace kriva::ui {
namespace {

/// Presses Cancel as soon as a dialog is there to press it in.
class Impatient : public QObject {
  public:
    Impatient() {
        connect(&looks_, &QTimer::timeout, this, [this] {
            const auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
            if (!dialog)
                return;
            text = dialog->windowTitle();
            dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
        });
        looks_.start(1);
    }
    QString text;

  private:
    QTimer looks_;
};

TEST(LongWork, givesWhatItWorkedOutOnAnotherThread) {
    const auto here = std::this_thread::get_id();
    const auto worked = workedOut<bool>([here](const std::stop_token&) { return std::this_thread::get_id() != here; },
                                        QStringLiteral("Working"), nullptr);
    EXPECT_EQ(worked, true);
}

TEST(LongWork, endsWhereAPersonWillNotWait) {
    const Impatient person;
    const auto worked = workedOut<int>(
        [](const std::stop_token& stop) {
            while (!stop.stop_requested()) // would never end
                std::this_thread::yield();
            return 1;
        },
        QStringLiteral("Working"), nullptr);
    EXPECT_EQ(worked, std::nullopt);
    EXPECT_EQ(person.text, QStringLiteral("Working"));
}

} // namespace
} // namespace kriva::ui
