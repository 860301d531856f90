#pragma once

#include "core/geometry/box.h"

#include <optional>
#include <string>
#include <string_view>

namespace kriva {

/// Builds a JSON text. Containers are broken into lines down to a depth, below that they stand in one line.
class JsonWriter {
  public:
    enum class Digits {
        shortest,  ///< the fewest that read back bit for bit
        seventeen, ///< 17 significant ones, as the report promises
    };
    explicit JsonWriter(Digits digits, int linesDownTo = 5)
        : digits_(digits)
        , linesDownTo_(linesDownTo) {}

    JsonWriter& beginObject() { return open('{'); }
    JsonWriter& endObject() { return close('}'); }
    JsonWriter& beginList() { return open('['); }
    JsonWriter& endList() { return close(']'); }
    JsonWriter& key(std::string_view name);

    /// What is not finite becomes null; -0.0 stays.
    JsonWriter& value(double number);
    JsonWriter& value(int number);
    JsonWriter& value(bool isTrue);
    /// What isUnprintable() is written as \uXXXX. What no reader takes, broken UTF-8 and NUL, becomes U+FFFD: whatever
    /// goes wrong before, a document that was written can be read again.
    JsonWriter& value(std::string_view text);
    JsonWriter& value(const char* text) { return value(std::string_view(text)); }
    JsonWriter& value(Point point);
    JsonWriter& value(Vector vector) { return value(Point{vector.x, vector.y}); }
    JsonWriter& value(const Box& box);
    JsonWriter& value(std::span<const Point> points);
    JsonWriter& value(std::span<const double> numbers);
    /// A list of anything that has a value, lists included.
    template <class Element>
    JsonWriter& value(const std::vector<Element>& elements);
    template <class Value>
    JsonWriter& value(const std::optional<Value>& maybe) {
        return maybe ? value(*maybe) : raw("null");
    }
    template <class Value>
    JsonWriter& member(std::string_view name, const Value& content) {
        return key(name).value(content);
    }

    [[nodiscard]] std::string take() &&;

  private:
    JsonWriter& open(char bracket);
    JsonWriter& close(char bracket);
    JsonWriter& raw(std::string_view text);
    void separate();
    void breakLine();

    std::string text_;
    Digits digits_;
    int linesDownTo_;
    int depth_ = 0;
    bool isFirst_ = true; ///< of its container
    bool isAfterKey_ = false;
};

template <class Element>
JsonWriter& JsonWriter::value(const std::vector<Element>& elements) {
    beginList();
    for (const Element& element : elements)
        value(element);
    return endList();
}

} // namespace kriva
