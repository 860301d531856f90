#pragma once

#include "core/intersections/contacts/segment_contacts.h"

namespace kriva {

/// The contacts inside two arcs of different segments; those at the ends of the segments may be missing.
class ContactSearch {
  public:
    ContactSearch(const ContactScale& scale, std::span<const Contact> joints, WorkBudget& budget)
        : scale_(scale)
        , joints_(joints)
        , budget_(budget) {}

    /// Appends what it finds; where the arcs touch along a stretch, several places of it.
    void search(const Arc& a, const Arc& b, std::vector<Contact>& found);

  private:
    void visit(const Arc& a, const Arc& b, int depth);
    [[nodiscard]] bool decide(const Arc& a, const Arc& b, bool atJoint);
    [[nodiscard]] std::optional<Contact> crossing(const Arc& a, const Arc& b) const;
    [[nodiscard]] bool areWithinTouching(const Arc& a, const Arc& b) const;
    void addTouching(const Arc& a, const Arc& b);

    ContactScale scale_;
    std::span<const Contact> joints_;
    WorkBudget& budget_;
    std::vector<Contact>* found_ = nullptr;
};

} // namespace kriva
