#include "ui/document/bounded_read.h"

#include <gtest/gtest.h>
#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <cerrno>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace kriva::ui {
namespace {

class BoundedRead : public ::testing::Test {
  protected:
    QString in(const QString& name) const { return folder.filePath(name); }
    QString put(const QByteArray& bytes) const {
        QFile file(in(u"file"_s));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        return file.fileName();
    }
    static QByteArray bytesOf(const std::variant<QByteArray, ReadError>& result) {
        return std::holds_alternative<QByteArray>(result) ? std::get<QByteArray>(result) : "refused";
    }
    static std::optional<ReadFault> faultOf(const std::variant<QByteArray, ReadError>& result) {
        const auto* error = std::get_if<ReadError>(&result);
        return error ? std::optional(error->fault) : std::nullopt;
    }

    QTemporaryDir folder;
};

TEST_F(BoundedRead, allBytesOfAFileComeBack) {
    for (const int size : {0, 1, 256 * 1024, 256 * 1024 + 1, 1'000'000}) {
        const QByteArray bytes(size, '\0');
        EXPECT_EQ(bytesOf(boundedRead(put(bytes))), bytes);
    }
}

TEST_F(BoundedRead, theLimitItselfIsReadAndOneByteMoreIsRefused) {
    const QString path = put(QByteArray(1000, 'x'));
    EXPECT_EQ(bytesOf(boundedRead(path, 1000)).size(), 1000);
    EXPECT_EQ(faultOf(boundedRead(path, 999)), ReadFault::TooLarge);
}

TEST_F(BoundedRead, sixtyFourMebibytesAreReadAndOneByteMoreIsRefused) {
    const QString path = put({});
    QFile::resize(path, kLargestFile);
    EXPECT_EQ(bytesOf(boundedRead(path)).size(), kLargestFile);
    QFile::resize(path, kLargestFile + 1);
    EXPECT_EQ(faultOf(boundedRead(path)), ReadFault::TooLarge);
}

TEST_F(BoundedRead, aFileThatHidesItsSizeIsBoundedToo) {
    const QString path = u"/proc/self/maps"_s; // claims to be of size 0
    EXPECT_GT(bytesOf(boundedRead(path)).size(), 100);
    EXPECT_EQ(faultOf(boundedRead(path, 100)), ReadFault::TooLarge);
}

TEST_F(BoundedRead, whatIsNoRegularFileIsRefusedWithoutWaiting) {
    ::mkfifo(QFile::encodeName(in(u"pipe"_s)).constData(), 0600);
    const int server = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address = {.sun_family = AF_UNIX, .sun_path = {}};
    const QByteArray socketName = QFile::encodeName(in(u"socket"_s));
    ASSERT_LT(static_cast<std::size_t>(socketName.size()), sizeof address.sun_path);
    std::copy(socketName.begin(), socketName.end(), address.sun_path);
    ASSERT_EQ(::bind(server, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    for (const QString& path : {in(u"pipe"_s), in(u"socket"_s), folder.path(), u"/dev/zero"_s, u"/dev/tty"_s})
        EXPECT_EQ(faultOf(boundedRead(path)), ReadFault::NotRegular) << path.toStdString();
    ::close(server);
}

TEST_F(BoundedRead, aMissingFileIsCalledMissing) {
    EXPECT_EQ(boundedRead(in(u"none"_s)), (std::variant<QByteArray, ReadError>(ReadError{ReadFault::Missing, ENOENT})));
    EXPECT_EQ(faultOf(boundedRead(put("x") + u"/below"_s)), ReadFault::Missing);
}

TEST_F(BoundedRead, aLinkLeadsToItsFile) {
    put("text");
    QFile::link(u"file"_s, in(u"link"_s));
    EXPECT_EQ(bytesOf(boundedRead(in(u"link"_s))), "text");
}

} // namespace
} // namespace kriva::ui
