#pragma once

#include "core/curve/json/json_tape.h"
#include "core/curve/limits.h"
#include "core/geometry/point.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>

namespace kriva {

/// Thrown by the readers below and caught by readJson: it never leaves core.
struct Refused {
    FileError error;
};

/// A value of a parsed document together with its place. Every reading function refuses what it does not expect.
/// A node refers to its parent, which must outlive it.
class JsonNode {
  public:
    explicit JsonNode(const JsonTape& tape)
        : tape_(&tape) {}

    [[nodiscard]] std::string place() const;
    [[nodiscard]] double number(double low = -limits::kNumber, double high = limits::kNumber) const;
    /// Strictly between low and high.
    [[nodiscard]] double numberBetween(double low, double high) const;
    /// 5.0 is a whole number; 2.5 and true are not.
    [[nodiscard]] int wholeNumber(int low, int high) const;
    [[nodiscard]] bool trueOrFalse() const;
    [[nodiscard]] std::string text() const;
    [[nodiscard]] Point point() const;
    [[nodiscard]] Vector vector() const;
    [[nodiscard]] Points points(std::size_t atMost = limits::kPointsInCurve) const;
    /// One of the words of a table.
    template <class Value, std::size_t size>
    [[nodiscard]] Value oneOf(std::span<const std::pair<std::string_view, Value>, size> table) const;
    template <class Value>
    [[nodiscard]] Value oneOf(std::initializer_list<std::pair<std::string_view, Value>> table) const {
        return oneOf(std::span(table.begin(), table.size()));
    }

    /// Refuses what is no list, or one with more elements than that.
    [[nodiscard]] std::size_t listSize(std::size_t atMost) const;
    /// Calls visit(JsonNode element) for each element of a list.
    template <class Visit>
    void forEachElement(Visit visit) const;
    /// Calls visit(int index, JsonNode member) for each member of an object whose keys are indices from 0 to below
    /// `count`, decimal without sign or leading zero; with count nothing, any index below the largest number of points
    /// is accepted. Refuses repeated keys.
    template <class Visit>
    void forEachIndexed(std::optional<std::size_t> count, Visit visit) const;

    /// The lists are not taken by value: GCC 12 frees them twice, at -O2, where a function that never returns moves
    /// from them and throws.
    [[noreturn]] void refuse(FileProblem problem, const std::vector<double>& numbers = {},
                             const std::vector<std::string>& words = {}) const;

  private:
    JsonNode(const JsonTape& tape, std::uint32_t index, const JsonNode* parent)
        : tape_(&tape)
        , index_(index)
        , parent_(parent) {}
    friend class JsonObject;

    [[nodiscard]] const JsonEntry& entry() const { return tape_->entries[index_]; }
    /// Calls visit(JsonNode member) for each member of an object in the order of the text, repeated keys included.
    template <class Visit>
    void forEachMember(Visit visit) const;
    [[nodiscard]] std::size_t indexOfKey(std::optional<std::size_t> count) const;

    const JsonTape* tape_;
    std::uint32_t index_ = 0;
    const JsonNode* parent_ = nullptr;
    std::string_view key_;     ///< of a member
    std::size_t position_ = 0; ///< of an element
};

/// An object whose keys are all known beforehand; refuses unknown and repeated ones.
class JsonObject {
  public:
    JsonObject(const JsonNode& node, std::span<const std::string_view> keys);
    JsonObject(const JsonNode& node, std::initializer_list<std::string_view> keys)
        : JsonObject(node, std::span(keys.begin(), keys.size())) {}

    [[nodiscard]] const JsonNode* find(std::string_view key) const;
    [[nodiscard]] const JsonNode& require(std::string_view key) const;

  private:
    const JsonNode* node_;
    std::vector<JsonNode> members_;
};

template <class Value, std::size_t size>
Value JsonNode::oneOf(std::span<const std::pair<std::string_view, Value>, size> table) const {
    std::vector<std::string> words;
    for (const auto& [word, value] : table) {
        if (entry().kind == JsonKind::text && textOf(*tape_, index_) == word)
            return value;
        words.emplace_back(word);
    }
    refuse(FileProblem::expectedOneOf, {}, words);
}

/// The word of a value in such a table, where it must be.
template <class Value, std::size_t size>
std::string_view wordOf(Value value, std::span<const std::pair<std::string_view, Value>, size> table) {
    return std::ranges::find(table, value, &std::pair<std::string_view, Value>::second)->first;
}
template <class Value>
std::string_view wordOf(Value value, std::initializer_list<std::pair<std::string_view, Value>> table) {
    return wordOf(value, std::span(table.begin(), table.size()));
}

template <class Visit>
void JsonNode::forEachElement(Visit visit) const {
    if (entry().kind != JsonKind::list)
        refuse(FileProblem::expectedList);
    std::size_t position = 0;
    for (std::uint32_t i = index_ + 1; i < entry().next; i = tape_->entries[i].next) {
        JsonNode element(*tape_, i, this);
        element.position_ = position++;
        visit(std::as_const(element));
    }
}

template <class Visit>
void JsonNode::forEachMember(Visit visit) const {
    if (entry().kind != JsonKind::object)
        refuse(FileProblem::expectedObject);
    for (std::uint32_t i = index_ + 1; i < entry().next; i = tape_->entries[i + 1].next) {
        JsonNode member(*tape_, i + 1, this);
        member.key_ = textOf(*tape_, i);
        visit(std::as_const(member));
    }
}

template <class Visit>
void JsonNode::forEachIndexed(std::optional<std::size_t> count, Visit visit) const {
    std::vector<bool> isThere;
    forEachMember([&](const JsonNode& member) {
        const std::size_t index = member.indexOfKey(count);
        isThere.resize(std::max(isThere.size(), index + 1));
        if (isThere[index])
            member.refuse(FileProblem::repeatedKey);
        isThere[index] = true;
        visit(static_cast<int>(index), member);
    });
}

} // namespace kriva
