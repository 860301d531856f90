#pragma once

namespace kriva {

/// What the curves of a sheet can do beyond what all of them can. A curve names it as kCapabilities; sheet.h lists the
/// functions that each one asks for, and no other is called.
struct Capabilities {
    bool handles = false;      ///< points have handles to pull: PullsHandles
    bool closing = false;      ///< an open curve can be closed: CanBeClosed
    bool pieces = false;       ///< a chain of pieces, each of which can be edited: IsMadeOfPieces
    bool animation = false;    ///< its algorithm runs in stages or over t: IsAnimated
    bool relations = false;    ///< curves have something with each other: HasRelations
    bool longDrawing = false;  ///< what is drawn takes long, so that it can be stopped: DrawsWithinBudget
    bool viewSettings = false; ///< its figure can be changed by numbers of the view: HasViewSettings
    bool outputLimits = false; ///< reports or files of figures have limits of its own: LimitsOutput
};

} // namespace kriva
