#include "app/commands/progress.h"
#include "tests/support/program.h"

#include <QDir>
#include <QScopeGuard>

#include <csignal>
#include <cstring>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace kriva::app {
namespace {

using namespace std::chrono_literals;

constexpr char kErased[] = "\r\x1b[K";

TEST(Progress, saysNothingForTwoSecondsAndCountsThem) {
    EXPECT_EQ(progressLine(QStringLiteral("a.kriva"), 0ms), "");
    EXPECT_EQ(progressLine(QStringLiteral("a.kriva"), 1999ms), "");
    EXPECT_TRUE(progressLine(QStringLiteral("a.kriva"), 2s).contains("kriva: a.kriva: at work for 2 s"));
    EXPECT_TRUE(progressLine(QStringLiteral("a.kriva"), 61s).contains("at work for 61 s"));
}

TEST(Progress, shownNamesCanNeitherMoveTheCursorNorStandForNumbers) {
    const QByteArray line = progressLine(QStringLiteral("\x1b[2J%2\n"), 2s);
    EXPECT_TRUE(line.contains("\\u001b[2J%2\\u000a: at work for 2 s")) << line.constData();
    EXPECT_EQ(line.count('\n'), 0);
}

TEST(Progress, tellsWhichOfSeveralFilesItIs) {
    EXPECT_EQ(fileOf({QStringLiteral("a")}, 0), QStringLiteral("a"));
    EXPECT_EQ(fileOf({QStringLiteral("a"), QStringLiteral("b%1")}, 1), QStringLiteral("b%1 (2/2)"));
}

/// A terminal of its own, at which the program is started. It waits for its input as long as the test wants.
class AtTerminal : public test::Program {
  protected:
    void SetUp() override {
        Program::SetUp();
        ASSERT_EQ(::openpty(&master_, &slave_, nullptr, nullptr, nullptr), 0) << std::strerror(errno);
    }
    void TearDown() override {
        ::close(master_);
        ::close(slave_);
    }

    void start(QProcess& process, const char* line, bool isAtTerminal = true) {
        shown_.clear();
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("TERM"), QStringLiteral("xterm"));
        process.setProcessEnvironment(environment);
        process.setWorkingDirectory(path({}));
        if (isAtTerminal)
            process.setChildProcessModifier([slave = slave_] {
                ::setsid();
                ::ioctl(slave, TIOCSCTTY, 0);
                ::dup2(slave, STDERR_FILENO);
            });
        process.start(QStringLiteral(KRIVA_PROGRAM), QString::fromUtf8(line).split(QLatin1Char(' ')));
        ASSERT_TRUE(process.waitForStarted());
    }
    /// Reads what is shown until it holds a text; false where it never does.
    [[nodiscard]] bool waitFor(const QByteArray& text) {
        while (!shown_.contains(text))
            if (!readMore(60'000))
                return false;
        return true;
    }
    [[nodiscard]] QByteArray allShown() {
        while (readMore(0)) {
        }
        return shown_;
    }
    void press(char key) const { EXPECT_EQ(::write(master_, &key, 1), 1); }
    [[nodiscard]] QStringList files() const {
        return QDir(path({})).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

  private:
    bool readMore(int milliseconds) {
        pollfd ready{master_, POLLIN, 0};
        std::array<char, 4096> bytes{};
        if (::poll(&ready, 1, milliseconds) != 1)
            return false;
        const ssize_t count = ::read(master_, bytes.data(), bytes.size());
        shown_.append(bytes.data(), std::max<ssize_t>(count, 0));
        return count > 0;
    }

    int master_ = -1;
    int slave_ = -1;
    QByteArray shown_;
};

TEST_F(AtTerminal, tellsOfLongWorkAndTakesTheLineBack) {
    QProcess process;
    start(process, "report - --format json --language en");
    ASSERT_TRUE(waitFor("kriva: -: at work for 2 s")) << allShown().constData();
    process.write(test::kArch);
    process.closeWriteChannel();
    ASSERT_TRUE(process.waitForFinished(60'000));
    EXPECT_EQ(process.exitCode(), 0);
    EXPECT_TRUE(allShown().endsWith(kErased)) << allShown().constData();
    const QByteArray out = process.readAllStandardOutput();
    EXPECT_TRUE(out.startsWith('{'));
    EXPECT_FALSE(out.contains('\x1b'));
}

TEST_F(AtTerminal, controlCEndsItAtOnceAndLeavesNothing) {
    for (const char* line : {"export - -o out.svg --language en", "import - -o out.kriva --sheet spline --language en",
                             "report - --language en"}) {
        const QStringList before = files();
        QProcess process;
        start(process, line);
        ASSERT_TRUE(waitFor("kriva: -: at work for ")) << line;
        press('\x03');
        ASSERT_TRUE(process.waitForFinished(60'000)) << line;
        EXPECT_EQ(process.exitStatus(), QProcess::CrashExit) << line;
        EXPECT_EQ(process.exitCode(), SIGINT) << "a shell tells 130: " << line;
        EXPECT_EQ(files(), before) << line;
        EXPECT_EQ(process.readAllStandardOutput(), "") << line;
        EXPECT_TRUE(allShown().contains(kErased)) << line;
    }
}

TEST_F(AtTerminal, tellsNothingWhereStderrIsNoTerminal) {
    QProcess quiet;
    QProcess shown;
    start(quiet, "report - --format json --language en", false);
    start(shown, "report - --format json --language en");
    ASSERT_TRUE(waitFor("at work for 3 s"));
    for (QProcess* process : {&quiet, &shown}) {
        process->write(test::kArch);
        process->closeWriteChannel();
        ASSERT_TRUE(process->waitForFinished(60'000));
        EXPECT_EQ(process->exitCode(), 0);
    }
    EXPECT_EQ(quiet.readAllStandardError(), "");
    EXPECT_EQ(quiet.readAllStandardOutput(), shown.readAllStandardOutput());
}

TEST_F(AtTerminal, anErrorTakesTheLineBackFirst) {
    QProcess process;
    start(process, "report - --language en");
    ASSERT_TRUE(waitFor("at work for 2 s"));
    process.write("nothing");
    process.closeWriteChannel();
    ASSERT_TRUE(process.waitForFinished(60'000));
    EXPECT_EQ(process.exitCode(), 3);
    EXPECT_TRUE(allShown().endsWith(kErased + QByteArray("kriva: -: line 1, column 2: this is no JSON\r\n")))
        << allShown().constData();
}

} // namespace
} // namespace kriva::app
