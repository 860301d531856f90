#include "core/io/svg/svg_path.h"

#include "core/io/drawing/drawn_pieces.h"
#include "core/io/numbers/plain_number.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kriva {
namespace {

/// Gathers text in a buffer of its own before it goes into a string.
class Buffer {
  public:
    explicit Buffer(std::string& text)
        : text_(text) {}
    ~Buffer() { flush(); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    void command(char letter, std::span<const Point> points, int decimals) {
        constexpr std::size_t kMostOfCommand = 8 + 6 * (kLongestPlainNumber + 1);
        if (static_cast<std::size_t>(buffer_.data() + buffer_.size() - end_) < kMostOfCommand)
            flush();
        *end_++ = letter;
        for (const Point p : points) {
            *end_++ = ' ';
            end_ = writePlainNumber(end_, p.x, decimals);
            *end_++ = ',';
            end_ = writePlainNumber(end_, p.y, decimals);
        }
    }
    void put(char c) { *end_++ = c; }

  private:
    void flush() {
        text_.append(buffer_.data(), end_);
        end_ = buffer_.data();
    }

    std::string& text_;
    std::array<char, 1u << 14> buffer_;
    char* end_ = buffer_.data();
};

} // namespace

void appendPathData(std::string& text, const Path& path, const Page& page, int decimals) {
    constexpr char kLetters[] = {'M', 'L', 'Q', 'C'};
    bool isStarted = false;
    Buffer buffer(text);
    forEachDrawnPiece(path, page, [&](std::span<const Point> piece) {
        if (!isStarted)
            buffer.command(kLetters[0], piece.first(1), decimals);
        isStarted = true;
        buffer.put(' ');
        buffer.command(kLetters[piece.size() - 1], piece.subspan(1), decimals);
    });
    if (isStarted && path.isClosed) {
        buffer.put(' ');
        buffer.put('Z');
    }
}

std::string pathData(const Path& path, const Page& page, int decimals) {
    std::string text;
    appendPathData(text, path, page, decimals);
    return text;
}

int decimalsOf(const Page& page) {
    const double side = std::max(page.width, page.height);
    return std::max(0, 13 - static_cast<int>(std::floor(std::log10(side))));
}

} // namespace kriva
