#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace kriva {

/// Reads the little languages of SVG's attributes: path data, lists of points, transforms, lengths. Numbers are read in
/// the C locale, to the last bit. It never looks back, so that reading is linear.
class SvgScanner {
  public:
    /// The text outlives this.
    explicit SvgScanner(std::string_view text)
        : rest_(text)
        , size_(text.size()) {}

    /// How many bytes have been read.
    [[nodiscard]] std::size_t position() const { return size_ - rest_.size(); }
    [[nodiscard]] bool isAtEnd() const { return rest_.empty(); }
    [[nodiscard]] std::string_view rest() const { return rest_; }
    void skipBlanks();
    /// Blanks with at most one comma among them.
    void skipSeparator();
    /// Whether the text goes on with this, which is read then.
    bool take(char c);
    /// The letters that come next, perhaps none.
    [[nodiscard]] std::string_view letters();
    /// A number, finite; nothing is read where there is none. Separators behind it are read too.
    [[nodiscard]] std::optional<double> number();
    /// 0 or 1, which need no separator behind it.
    [[nodiscard]] std::optional<bool> flag();

  private:
    std::string_view rest_;
    std::size_t size_;
};

} // namespace kriva
