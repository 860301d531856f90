#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <stop_token>
#include <utility>

namespace kriva {

/// Why long work ended before it was done.
enum class WorkEnd {
    stopped,      ///< somebody asked it to
    beyondBudget, ///< it would have taken more steps than it may
    tooMuchFound  ///< there is more to find than anyone asks for
};

/// How much long work may do, and the sign by which another thread ends it.
///
/// Steps are counted and not timed, so that one input has one answer on every machine; one stands for some 25
/// nanoseconds, in which a point of a cubic is evaluated. A loop spends before each round and returns where it may not
/// go on. What has ended gives nothing of use; functions that may end give nothing then, and `end()` says why.
class WorkBudget {
  public:
    static constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

    explicit WorkBudget(std::uint64_t steps = kUnlimited, std::stop_token stop = {})
        : most_(steps)
        , stop_(std::move(stop)) {}

    /// Whether the work may go on by so many steps. Once it may not, it never may again.
    [[nodiscard]] bool spend(std::uint64_t steps = 1) {
        spent_ += steps;
        if (end_)
            return false;
        if (stop_.stop_requested())
            end_ = WorkEnd::stopped;
        else if (spent_ > most_)
            end_ = WorkEnd::beyondBudget;
        return !end_;
    }

    /// Ends the work for a reason of its own.
    void endFor(WorkEnd reason) {
        if (!end_)
            end_ = reason;
    }

    /// Nothing as long as the work may go on.
    [[nodiscard]] std::optional<WorkEnd> end() const { return end_; }

    /// The steps asked for so far, granted or not.
    [[nodiscard]] std::uint64_t spent() const { return spent_; }

  private:
    std::uint64_t most_;
    std::uint64_t spent_ = 0;
    std::stop_token stop_;
    std::optional<WorkEnd> end_;
};

/// What work gives that nobody ends: `work` takes a budget and gives an optional.
template <class Work>
[[nodiscard]] auto withoutLimit(const Work& work) {
    WorkBudget budget;
    return *work(budget);
}

} // namespace kriva
