#pragma once

// All that the sheet `combined` brings to the document.
#include "core/sheets/combined/combined.h"
#include "core/sheets/combined/combined_curve.h"
#include "core/sheets/combined/combined_edits.h"
#include "core/sheets/combined/combined_figure.h"
#include "core/sheets/combined/combined_json.h"
#include "core/sheets/combined/combined_report.h"
