#pragma once

#include "app/commands/terminal.h"
#include "ui/document/safe_write.h"

#include <gtest/gtest.h>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

namespace kriva::test {

struct Outcome {
    int code = -1;
    QByteArray out;
    QByteArray error;
};

inline constexpr const char* kArch =
    R"({"format":"kriva","version":1,"active":"subdivision","sheets":{"elevation":{"curves":[
    {"name":"arch","points":[[0,0],[1,2],[3,2],[4,0.5]],"times":3}]}}})";

/// Runs the program as a person does, in a folder of its own and without a display.
class Program : public testing::Test {
  protected:
    void SetUp() override { write("arch.kriva", kArch); }

    [[nodiscard]] QString path(const QString& name) const { return folder_.filePath(name); }
    void write(const char* name, const QByteArray& bytes) const {
        EXPECT_FALSE(ui::safeWrite(path(QString::fromUtf8(name)), bytes));
    }
    [[nodiscard]] QByteArray read(const char* name) const {
        QFile file(path(QString::fromUtf8(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    [[nodiscard]] Outcome run(const QStringList& arguments, const QString& output = {},
                              const QString& input = {}) const {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
            environment.remove(QString::fromUtf8(name));
        environment.insert(QStringLiteral("LANGUAGE"), QStringLiteral("en")); // also before --language is read
        process.setProcessEnvironment(environment);
        process.setWorkingDirectory(folder_.path());
        if (!input.isEmpty())
            process.setStandardInputFile(input);
        if (!output.isEmpty())
            process.setStandardOutputFile(output);
        process.start(QStringLiteral(KRIVA_PROGRAM), arguments);
        EXPECT_TRUE(process.waitForFinished(60'000)) << "it hangs";
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
        return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
    }
    [[nodiscard]] Outcome run(const char* line, const QString& output = {}) const {
        return run(QString::fromUtf8(line).split(QLatin1Char(' ')) << QStringLiteral("--language=en"), output);
    }

  private:
    QTemporaryDir folder_;
};

inline void expectOneLine(const Outcome& outcome, app::ExitCode code, const char* line) {
    EXPECT_EQ(outcome.code, static_cast<int>(code));
    EXPECT_EQ(outcome.out, QByteArray());
    EXPECT_EQ(outcome.error, QByteArray(line) + '\n');
}

} // namespace kriva::test
