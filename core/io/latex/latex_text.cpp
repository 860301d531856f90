#include "core/io/latex/latex_text.h"

#include "core/curve/text/utf8.h"

#include <algorithm>
#include <array>

namespace kriva {
namespace {

/// Characters that do not stand for themselves; between dollars where `isFormula`.
struct LatexSign {
    char32_t character;
    std::string_view text;
    bool isFormula = true;
};

constexpr std::array kLatexSigns{
    LatexSign{U'\\', R"(\textbackslash{})", false},
    LatexSign{U'~', R"(\textasciitilde{})", false},
    LatexSign{U'^', R"(\textasciicircum{})", false},
    LatexSign{U'&', R"(\&)", false},
    LatexSign{U'%', R"(\%)", false},
    LatexSign{U'$', R"(\$)", false},
    LatexSign{U'#', R"(\#)", false},
    LatexSign{U'_', R"(\_)", false},
    LatexSign{U'{', R"(\{)", false},
    LatexSign{U'}', R"(\})", false},
    LatexSign{U'<', "<"},
    LatexSign{U'>', ">"},
    LatexSign{U'|', "|"},
    LatexSign{U'−', "-"},
    LatexSign{U'×', R"(\times)"},
    LatexSign{U'·', R"(\cdot)"},
    LatexSign{U'±', R"(\pm)"},
    LatexSign{U'≤', R"(\le)"},
    LatexSign{U'≥', R"(\ge)"},
    LatexSign{U'≈', R"(\approx)"},
    LatexSign{U'∞', R"(\infty)"},
    LatexSign{U'′', "'"},
    LatexSign{U'″', "''"},
    LatexSign{U'δ', R"(\delta)"},
    LatexSign{U'κ', R"(\kappa)"},
    LatexSign{U'…', R"(\ldots)"},
    LatexSign{U'⁻', "^{-}"},
    LatexSign{U'⁰', "^{0}"},
    LatexSign{U'¹', "^{1}"},
    LatexSign{U'²', "^{2}"},
    LatexSign{U'³', "^{3}"},
    LatexSign{U'⁴', "^{4}"},
    LatexSign{U'⁵', "^{5}"},
    LatexSign{U'⁶', "^{6}"},
    LatexSign{U'⁷', "^{7}"},
    LatexSign{U'⁸', "^{8}"},
    LatexSign{U'⁹', "^{9}"},
};

constexpr char32_t kFirstPrintable = 0x20;
constexpr char32_t kDelete = 0x7f;
constexpr char32_t kFirstBeyondControls = 0xa0;

bool isControl(char32_t c) {
    return c < kFirstPrintable || (c >= kDelete && c < kFirstBeyondControls);
}

std::string escaped(std::string_view text, std::string_view dollar) {
    std::string result;
    forEachCharacter(text, [&](std::optional<char32_t> character, std::string_view bytes) {
        const auto* sign = character ? std::ranges::find(kLatexSigns, *character, &LatexSign::character) : nullptr;
        if (!character || isControl(*character))
            result += ' ';
        else if (sign == kLatexSigns.end())
            result += bytes;
        else if (sign->isFormula)
            result.append(dollar).append(sign->text).append(dollar);
        else
            result += sign->text;
    });
    return result;
}

} // namespace

std::string latexText(std::string_view text) {
    return escaped(text, "$");
}

std::string latexFormula(std::string_view text) {
    return escaped(text, "");
}

bool hasCyrillic(std::string_view text) {
    bool has = false;
    forEachCharacter(text, [&](std::optional<char32_t> character, std::string_view) {
        has |= character && *character >= U'\u0400' && *character <= U'\u04ff';
    });
    return has;
}

} // namespace kriva
