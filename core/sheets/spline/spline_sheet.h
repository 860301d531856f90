#pragma once

// All that the sheet `spline` brings to the document.
#include "core/sheets/spline/chain/spline.h"
#include "core/sheets/spline/editing/chain_edits.h"
#include "core/sheets/spline/editing/handle_drag.h"
#include "core/sheets/spline/editing/removal.h"
#include "core/sheets/spline/editing/spline_edits.h"
#include "core/sheets/spline/spline_crossings.h"
#include "core/sheets/spline/spline_figure.h"
#include "core/sheets/spline/spline_json.h"
#include "core/sheets/spline/spline_report.h"
