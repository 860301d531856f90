#pragma once

#include "core/crossings/segment_contacts.h"

namespace kriva {

/// The contacts inside two arcs of different segments; those at the ends of the segments may be missing.
class ContactSearch {
  public:
    ContactSearch(const ContactScale& scale, std::span<const Contact> joints)
        : scale_(scale)
        , joints_(joints) {}

    /// Appends what it finds.
    void search(const Arc& a, const Arc& b, std::vector<Contact>& found);

  private:
    /// A pair of arcs that lie within `touching` throughout.
    struct Cell {
        double aFrom;
        double aTo;
        double bFrom;
        double bTo;
    };

    void visit(const Arc& a, const Arc& b, int depth);
    [[nodiscard]] bool decide(const Arc& a, const Arc& b, bool atJoint);
    [[nodiscard]] std::optional<Contact> crossing(const Arc& a, const Arc& b) const;
    [[nodiscard]] bool areWithinTouching(const Arc& a, const Arc& b) const;
    void uniteCells(const Arc& a, const Arc& b);

    ContactScale scale_;
    std::span<const Contact> joints_;
    std::vector<Contact>* found_ = nullptr;
    std::vector<Cell> cells_;
};

} // namespace kriva
