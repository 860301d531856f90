#pragma once

// All that the sheet `spline` brings to the document.
#include "core/spline/editing/chain_edits.h"
#include "core/spline/editing/handle_drag.h"
#include "core/spline/editing/removal.h"
#include "core/spline/spline.h"
#include "core/spline/spline_crossings.h"
#include "core/spline/spline_edits.h"
#include "core/spline/spline_figure.h"
#include "core/spline/spline_json.h"
#include "core/spline/spline_report.h"
