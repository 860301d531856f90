#include "core/curve/json/json_node.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace kriva {

std::string JsonNode::place() const {
    if (!parent_)
        return {};
    std::string place = parent_->place();
    if (parent_->entry().kind == JsonKind::list)
        appendPosition(place, position_);
    else
        appendKey(place, key_);
    return place;
}

void JsonNode::refuse(FileProblem problem, const std::vector<double>& numbers,
                      const std::vector<std::string>& words) const {
    FileError error;
    error.problem = problem;
    error.place = place();
    error.numbers = numbers;
    error.words = words;
    throw Refused{std::move(error)};
}

double JsonNode::number(double low, double high) const {
    if (entry().kind != JsonKind::number)
        refuse(FileProblem::expectedNumber);
    if (!(entry().number >= low && entry().number <= high))
        refuse(FileProblem::numberOutOfRange, {low, high});
    return entry().number;
}

double JsonNode::numberBetween(double low, double high) const {
    if (entry().kind != JsonKind::number)
        refuse(FileProblem::expectedNumber);
    if (!(entry().number > low && entry().number < high))
        refuse(FileProblem::numberOutOfOpenRange, {low, high});
    return entry().number;
}

int JsonNode::wholeNumber(int low, int high) const {
    const bool isWhole = entry().kind == JsonKind::number && entry().number == std::trunc(entry().number);
    if (!isWhole || !(entry().number >= low && entry().number <= high))
        refuse(FileProblem::expectedWholeNumber, {static_cast<double>(low), static_cast<double>(high)});
    return static_cast<int>(entry().number);
}

bool JsonNode::trueOrFalse() const {
    if (entry().kind != JsonKind::boolean)
        refuse(FileProblem::expectedTrueOrFalse);
    return entry().number != 0;
}

std::string JsonNode::text() const {
    if (entry().kind != JsonKind::text || textOf(*tape_, index_).find('\0') != std::string_view::npos)
        refuse(FileProblem::expectedText);
    return std::string(textOf(*tape_, index_));
}

Vector JsonNode::vector() const {
    const auto& entries = tape_->entries;
    const bool isPair = entry().kind == JsonKind::list && entry().next == index_ + 3 &&
                        entries[index_ + 1].kind == JsonKind::number && entries[index_ + 2].kind == JsonKind::number;
    if (!isPair)
        refuse(FileProblem::expectedTwoNumbers);
    const Vector value{entries[index_ + 1].number, entries[index_ + 2].number};
    if (!(std::abs(value.x) <= limits::kNumber && std::abs(value.y) <= limits::kNumber))
        refuse(FileProblem::numberOutOfRange, {-limits::kNumber, limits::kNumber});
    return value;
}

Point JsonNode::point() const {
    const Vector fromOrigin = vector();
    return {fromOrigin.x, fromOrigin.y}; // the sum with the origin would turn -0.0 into 0
}

Points JsonNode::points(std::size_t atMost) const {
    Points points;
    points.reserve(listSize(atMost));
    forEachElement([&](const JsonNode& element) { points.push_back(element.point()); });
    return points;
}

std::size_t JsonNode::listSize(std::size_t atMost) const {
    std::size_t size = 0;
    forEachElement([&](const JsonNode&) {
        if (++size > atMost)
            refuse(FileProblem::tooMany, {static_cast<double>(atMost)});
    });
    return size;
}

std::size_t JsonNode::indexOfKey(std::optional<std::size_t> count) const {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(key_.data(), key_.data() + key_.size(), index);
    const bool isDecimal =
        error == std::errc() && end == key_.data() + key_.size() && (key_.size() == 1 || key_[0] != '0');
    if (!isDecimal || index >= count.value_or(limits::kPointsInCurve))
        refuse(FileProblem::noSuchIndex);
    return index;
}

JsonObject::JsonObject(const JsonNode& node, std::span<const std::string_view> keys)
    : node_(&node) {
    node.forEachMember([&](const JsonNode& member) {
        if (std::find(keys.begin(), keys.end(), member.key_) == keys.end())
            member.refuse(FileProblem::unknownKey);
        if (find(member.key_))
            member.refuse(FileProblem::repeatedKey);
        members_.push_back(member);
    });
}

const JsonNode* JsonObject::find(std::string_view key) const {
    const auto found = std::find_if(members_.begin(), members_.end(), [&](const JsonNode& m) { return m.key_ == key; });
    return found == members_.end() ? nullptr : &*found;
}

const JsonNode& JsonObject::require(std::string_view key) const {
    if (const JsonNode* found = find(key))
        return *found;
    node_->refuse(FileProblem::missingKey, {}, {std::string(key)});
}

} // namespace kriva
