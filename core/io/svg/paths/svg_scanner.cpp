#include "core/io/svg/paths/svg_scanner.h"

#include <charconv>
#include <cmath>

namespace kriva {
namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

} // namespace

void SvgScanner::skipBlanks() {
    while (!rest_.empty() && isBlank(rest_.front()))
        rest_.remove_prefix(1);
}

void SvgScanner::skipSeparator() {
    skipBlanks();
    if (take(','))
        skipBlanks();
}

bool SvgScanner::take(char c) {
    if (!rest_.starts_with(c))
        return false;
    rest_.remove_prefix(1);
    return true;
}

std::string_view SvgScanner::letters() {
    std::size_t count = 0;
    while (count < rest_.size() && isLetter(rest_[count]))
        ++count;
    const std::string_view found = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return found;
}

std::optional<double> SvgScanner::number() {
    std::string_view text = rest_;
    if (text.starts_with('+'))
        text.remove_prefix(1);
    // from_chars would take "inf", "nan" and, behind a plus, a minus.
    const std::size_t first = text.starts_with('-') && text.size() == rest_.size() ? 1 : 0;
    if (text.size() <= first || !(isDigit(text[first]) || text[first] == '.'))
        return {};
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || !std::isfinite(value))
        return {};
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    skipSeparator();
    return value;
}

std::optional<bool> SvgScanner::flag() {
    if (rest_.empty() || (rest_.front() != '0' && rest_.front() != '1'))
        return {};
    const bool value = rest_.front() == '1';
    rest_.remove_prefix(1);
    skipSeparator();
    return value;
}

} // namespace kriva
